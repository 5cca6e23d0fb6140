/**
 * `#rrggbb` of a computed colour, without its opacity.
 * @param computed `rgb()`, `rgba()` or `color(srgb)`, as browsers compute `color-mix(in srgb)`
 */
export function hexOfComputed(computed: string): string {
  const bytes = computed.startsWith('rgb') ? 1 : 255;
  const channels = computed.replace('srgb', '').match(/none|-?[\d.]+(e-?\d+)?/g) ?? [];
  const hex = (channel = '0') => {
    const byte = Math.min(Math.max(Math.round(bytes * (Number.parseFloat(channel) || 0)), 0), 255);
    return byte.toString(16).padStart(2, '0');
  };
  return `#${hex(channels[0])}${hex(channels[1])}${hex(channels[2])}`;
}
