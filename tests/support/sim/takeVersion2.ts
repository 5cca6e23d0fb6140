/** A take of format version 2, recorded by the last release that wrote it. */

/** In the encoding of links: 60 steps of the preset wisp, with wind after 10 steps and a gust after 20. */
export const TAKE_2 = [
  'jVfNixxFFK8JenCXZD-SNZsQPVQQPEya2dnZXWmUHvAfUAniwUtt9-uZYnu62qrq2ZkJCwqCR70quUU8-i9EzEVRIaISBA8eRJAIBj9AT5rqnq',
  'qu7plaU4f9qN_vV_Xeq1fvVUtyBGcQQl9_e-ejj9-5H8ecjX5bRaiFEHpP_ZiP5-e_n7mK3_7p5u9fRAihswghGFEhKEs9TiSUlG5_wwYSGoOk',
  'ozm42T9vgwPOjuXwOh3BB--r0epfsGFIJSc0HUEqtSFPIISyPI49QWfzNR8Ea3pyTDglkrJUlNB6_xxCKGY8BOENOBlTObVFc-QwZ1OShgbaqC',
  'CZ88M8gTSE3WL8EZytwDHjEiZatVoBEScDPW3xj2kaeRPtShOYuoCZBlRw5l54JAwhAV54q_EthJD2pUb46ks1fg0u2ISQsYSmg-vmcNb7KrrK',
  'dus4_w7O6ck3chKp9UK93wpCqLBwkAspbPPNbLU66hu6GALhmr6qZ4dAB0Nz0OsIoSr4nsgAog-zF1bu3fokaGIhSSAuxs_BZh1joSRj0LYV6W',
  'WhMGZJXkXwbqAiKOgoT4qweTSVMOBEMm67LOQ0AW_Ikkif8XqZtVICF17HE0OSmeTcqmMZE7RY2-SBizC9d0v5e9-5gsmLJ-uEiHII63s4GSbn',
  'nQyzy0adwUlEc1Heim-aEaBpCry8078E5-sYTCSkUtv2owOeng7PNLzZCH3OYxLqlEPNg1FZVJr1eXBpCfaqLiDar40miQOJNLjZdHoInJoMXm',
  'tI6Qzu_PXs6-9--l2wvQgt7Nzwu15HHwRXlsNmGZ3RjXOVMMpUUch5rXraDJpKV_iGpJI1Fj7MuZBeyPJK3QgwpGNIWAaekIQb0hUHKcrrte2y',
  'g5cBpyzSrG0HKyaRKyc4HVB9kW-r2hVBKlSF7XhkYERrNWBMktwEwtbsVJoysBVgacoaqaGuS9N1a3Zdml23pufS9NyaPZdmz63Zd2n23ZoDl-',
  'agrlFJp7ouVc2x44WUh_NaXd7qf25vNRiMwytFpSoJ3xeVyiJwIOFwLi4utIVlnMU0MZtv1FGaxgk71mBDmmcRJ7HJ8oZVzSZwt2l21QTK1o36',
  'LsLMYR2ZUFHV_2Xg9DRwpg_jYjNcA7Wr1eHKK7xIWWx0_8ObPiLPeLy93DQ6A888yk7hTB-BY8JweTmHxTIFYbrgpTrLXfGWkZZVvGW8xYq3jN',
  'WseLbxdsUrHvlHMBWq37QW3p6ThA3Ey4qjPhPQY-rnysoqssafgf3fU4ql_vjhcYSyi-Vk683PHjp-89_XzjxtiCmT8FYLoZMWQjdwccsF9m9g',
  'EUIK2MfHVGS4jWtfGNjfec6a0k0P-z1vz5qvPiuw3_W6bVy-2MSIHcGLLGEc-_hqHMck7uA2TtSz0yMzOsrlEPu7HT0FCYyLE8F-r9PGC18E2N',
  '9RizdfotjveAdtbD0jR2TyElHhT5SLvU6njZcXMexf2_H266gpYGrdXg0rapeyoi6pbh72r3W87t5ydKqCs3Ny8h8',
].join('');

/** The hash at its end in the version that recorded it. No change since then affects this preset. */
export const HASH_2 = 'e93357ea1dd8c2a7';
