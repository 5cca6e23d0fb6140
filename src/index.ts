/** Exports of the package. No module of the library imports this file. */
export { CartoonSmokeElement } from './element/cartoonSmokeElement.ts';
export type { SmokeEvent, SmokeEvents, StateChange } from './element/events.ts';
export { createDevice, type Device, type DeviceCanvas } from './device/device.ts';
export {
  ContextError,
  LoadError,
  ParameterError,
  ShapeError,
  SimulatorError,
  SmokeError,
  UnsupportedError,
} from './preset/errors.ts';
export type { Value, Values } from './preset/parameter.ts';
export { presets, presetValues, type Preset } from './preset/presets.ts';
export type { PlainMesh } from './puffs/fit/closedMesh.ts';
export { fitPuff, type FitOptions, type FittedPuff } from './puffs/fit/fitPuff.ts';
export { designedShapes, type PuffDesign } from './puffs/lobeShapes.ts';
export type { Lobe, PuffShape } from './puffs/shapes.ts';
export { CartoonSmoke } from './three/cartoonSmoke.ts';
export type { CartoonSmokeEvents, CartoonSmokeOptions, CartoonSmokeStats, CastOptions } from './three/options.ts';
export type { CollideOptions } from './three/colliders.ts';
export type { KeyLight } from './three/keyLight.ts';
export { capsule, type ProxyBall, type ProxyCapsule } from './three/proxies.ts';
export type { RemoteMethods, RemoteStage, RemoteStageOptions, Thread } from './remote/contract.ts';
export { connectFrame, type ConnectOptions } from './remote/connectFrame.ts';
export { openStage } from './remote/openStage.ts';
export { bakedPuffs } from './smoke/bakedPuffs.ts';
export type {
  EnterOptions,
  PointerInput,
  SeekOptions,
  StageEvents,
  StageOptions,
  StageStats,
} from './stage/contract.ts';
export type { BlowInput } from './stage/blow.ts';
export { createStage, type Stage } from './stage/stage.ts';
export type { Take } from './stage/take.ts';
