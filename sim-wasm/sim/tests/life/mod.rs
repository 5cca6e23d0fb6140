//! Radius, ageing, death and held drawing.

mod ageing;
mod company;
mod curves;
mod flow;
mod hold;
mod looks;
