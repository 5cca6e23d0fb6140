/** Exports of the package. No module of the library imports this file. */
export { CartoonSmokeElement } from './element/cartoonSmokeElement.ts';
export type { SmokeEvent, SmokeEvents, StateChange } from './element/events.ts';
export type { StageMethods } from './element/methods.ts';
export {
  createDevice,
  type ContextEvent,
  type Device,
  type DeviceCanvas,
  type DeviceOptions,
} from './device/device.ts';
export { setAssetUrls, type AssetUrls } from './preset/assetUrls.ts';
export {
  ContextError,
  FileError,
  LoadError,
  ParameterError,
  ShapeError,
  SimulatorError,
  SmokeError,
  UnsupportedError,
} from './preset/errors.ts';
export type { AnyValues, ShareLink, Value, Values } from './preset/parameter.ts';
export type { ItemIndex, ItemValues, ListValues, PresetName, SingleValues } from './preset/valueTypes.ts';
export { presetValues } from './preset/presets.ts';
export { presets, type Preset } from './preset/words/presets.ts';
export type { DebugView, Quality } from './preset/quality.ts';
export type { PlainMesh } from './puffs/fit/closedMesh.ts';
export { fitPuff, type FitOptions, type FittedPuff } from './puffs/fit/fitPuff.ts';
export { designedShapes, type PuffDesign } from './puffs/lobeShapes.ts';
export type { PuffKnobs } from './puffs/procedural.ts';
export type { Lobe, PuffShape } from './puffs/shapes.ts';
export { CartoonSmoke } from './three/cartoonSmoke.ts';
export type { CartoonSmokeEvents, CartoonSmokeOptions, CartoonSmokeStats, CastOptions } from './three/options.ts';
export type { CollideOptions } from './three/colliders.ts';
export type {
  BurstOptions,
  EmissionChange,
  EmissionOptions,
  EmitterOptions,
  PuffOptions,
  VectorComponents,
} from './sim/emitterOptions.ts';
export type { EmitterHandle } from './three/emitters.ts';
export type { SmokeSpace } from './three/frame.ts';
export type { SmokeHandle } from './three/handle.ts';
export type { KeyLight } from './three/keyLight.ts';
export { capsule, type ProxyBall, type ProxyCapsule } from './three/proxies.ts';
export type { RemoteStage, RemoteStageOptions, Thread } from './remote/contract.ts';
export type { MethodName, RemoteMethod, RemoteMethods } from './remote/methods.ts';
export { connectFrame, type ConnectOptions } from './remote/connectFrame.ts';
export { openStage } from './remote/openStage.ts';
export type { Vector } from './scenes/scene.ts';
export type { LoadProgress } from './sim/load.ts';
export type { RigidSurface } from './sim/rigid.ts';
export type { EnterOptions, PointerInput, SeekOptions, StageEvents, StageOptions } from './stage/contract.ts';
export type { BlowInput } from './stage/blow.ts';
export type { PicturePoint, ScenePlane, Sight } from './stage/sight.ts';
export { createStage, type Stage } from './stage/stage.ts';
export type { StageStats, StatsOptions } from './stage/stats.ts';
export type { Take } from './stage/take.ts';
