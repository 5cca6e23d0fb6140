/** A recorded take, so that takes that people keep stay readable. */

/** In the encoding of links: 60 steps of the preset wisp, with wind after 10 steps and a gust after 20. */
export const TAKE = [
  'jVfNixxFFJ8N8eAuSXY3WfNB9NBB8BCb2dkvGZQe8B9QCeLBS23365lie7o6VdWz0xMWIgge9arkFvHov7BiLooKEZUgePAggkQw-AF60lfdU93VPV',
  '1rGqpnpn6_9-rVq3q_qpHkAJY6nc7X39776ON3HoYhZ-PfVjod1feees2fF-efz15z3v7pzu9fBPj9DDYYUyEoi11OJBSU3mDNBCIagqTjObg-OG-C',
  'Q84O5egGwh-8r56lwQUThlhyQuMxfupAnsSWpGHoCjqb-3zkndOdE8IpkWgqCmh1cBbfIeM-CByMTKjMTKM5sp-yjMR-Ca1VkEz5fhpB7MNW_vzhna',
  'nACeMSptpqpQICToa62-Af0jhwp3oqTSCzATMNqOTMZ-ES34cIeD5bjW9g03OpEb76Uj2_ehdMgs9YROPhjXJxVgcquyp2Yzn_9s7qzpspCZQ_X4-3',
  'jC2PcJgKKczwy97Ke2dQ0sUICNf0Fd07AjoclQu9iq1KvisSgODD5KXlB3c_8ZqYTyII8-dnb72OMV-SCejY8u1loDBhUVpl8L6nMijoOI3ytLk0lo',
  'AJl4ybUxYyi8AdsSjQa7xa7FopgQu3i_MjSbk5N-pYwgTNfU_NVWsjZA_uqvk-tHoo98VTdUJAOfj1MayMcs9bGeUoa3UGJwFNRVEV3zQzQOMYeFHT',
  'v3jn6xhMJRa0ju1HC5ydDM80vN5IfcpD4oO5i0xU7aIirM-9yy3Y61pA9LzWmiQOJNDgenPSI-C03MHnGqYoWPf-eu7Ndz_9zru0CC2M3Jh3XUcfeV',
  'fb4dKN3tGNdZUwTpQopLymniaDxtKWvhGpzBqO91MuJGpKWlk3EgzxBCKWYL1KwkvSVQspSOvadsXCw9lQFmjWJQsrJIFtT3A6pLqQj5V2BRALpbBd',
  'lwzBXMwKmJAoBVPgNbRZ2RSJrQDDptBIDfVsNj27zZbNZstus22z2bbb7Nhsduw2uzabXbvNns1mr26jNp06dak6HLuuT7k_1-qiqv853mgwGIfXcq',
  'UqCN_nSmUQsJ790dw4L2gDSzgLaQSmABoojcOIHWqwYZomeFSG0tR403HjELh_bCNkxdHdGdgIM0t0ZEpFpf9tYHYSONOLcbGZrqEa1TjhihJepCwe',
  'dP_Dyx6TNzOLvSU0FFO3vJSdwMkeg1Om4Uo7h4UyBlGegpfrLLvitZHaFK-Nt6h4baym4pnBm4qXX_IPIBPqvFlauHtOIzYUryrOKfU6rd7Lyysd4_',
  'nTM389rVjqyw9P4KX8YtG5dPszfN_5941Tz5TEmEl4C0c_wnbLyatcOP1bjvAhBqfvHFKRONed2j8Mp7_5gtGlDz2nv-3uGP3V3wqn33N7153ixibG',
  '7ABeZhHj6P4a3hZJ2MURInXtdMkMr31y5PS3uroLr8-TfEXQP3Yu_CPAaJTz5k3U6XfdPRyzukaOyfQVotIfqSlud9FZu4g5_ec33d06WgqY8rtdw3',
  'LtUlHUTarKQ39dt7fTjmYqOZtHR_8B',
].join('');

/** The hash at its end. */
export const TAKE_HASH = 'e93357ea1dd8c2a7';
