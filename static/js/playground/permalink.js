/** The playground's state in its address: what stands behind # is the whole robot, and nothing is stored elsewhere. */

/**
 * @typedef {{table: any, parameters: Record<string, number>, joints: number[]}} Shared
 *   a table as it goes to the API, values of its parameters, joint values [rad or length]
 */

/** @param {Shared} shared @returns {string} */
export function encode(shared) {
  const bytes = new TextEncoder().encode(JSON.stringify(shared));
  const text = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** What an address's fragment holds, or null if it holds no robot. @param {string} fragment @returns {Shared | null} */
export function decode(fragment) {
  const match = /^#robot=([\w-]+)$/.exec(fragment);
  if (!match) return null;
  try {
    const text = atob(match[1].replaceAll("-", "+").replaceAll("_", "/"));
    const shared = JSON.parse(new TextDecoder().decode(Uint8Array.from(text, (c) => c.charCodeAt(0))));
    if (!Array.isArray(shared?.table?.rows)) return null;
    return { table: shared.table, parameters: shared.parameters ?? {}, joints: shared.joints ?? [] };
  } catch {
    return null;
  }
}

/** The page's address with the robot in it. @param {string} address @param {Shared} shared */
export function permalink(address, shared) {
  const url = new URL(address);
  url.hash = `robot=${encode(shared)}`;
  return url.href;
}
