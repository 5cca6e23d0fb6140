//! Radius, ageing, death and held drawing.

mod ageing;
mod curves;
mod flow;
mod hold;
