// Lengths as words. The program gives meters with all digits; what is shown is rounded only here.

const INCH = 0.0254;
// A tailor's tape in inches is divided into sixteenths.
const SIXTEENTHS = 16;

export const UNITS = {
  cm: { label: "cm", perMeter: 100, digits: 2 },
  mm: { label: "mm", perMeter: 1000, digits: 1 },
  in: { label: "in", perMeter: 1 / INCH, digits: 3 },
};

/** A length as a number without a unit, as a spreadsheet takes it. */
export function plainLength(meters, unit, digits) {
  const { perMeter, digits: usual } = UNITS[unit] ?? { perMeter: 1, digits: 4 };
  return (meters * perMeter).toFixed(digits ?? usual);
}

function fractionOfInch(meters) {
  const sixteenths = Math.round((Math.abs(meters) / INCH) * SIXTEENTHS);
  const whole = Math.floor(sixteenths / SIXTEENTHS);
  let over = sixteenths % SIXTEENTHS;
  let under = SIXTEENTHS;
  while (over && over % 2 === 0) [over, under] = [over / 2, under / 2];
  const sign = meters < 0 && sixteenths > 0 ? "−" : "";
  if (!over) return `${sign}${whole}`;
  return whole ? `${sign}${whole} ${over}/${under}` : `${sign}${over}/${under}`;
}

/** A length with its unit. `unit` is "" for a body whose own unit is not known. */
export function formatLength(meters, unit, digits) {
  if (!Number.isFinite(meters)) return "no length";
  if (unit === "in" && digits === undefined) return `${fractionOfInch(meters)} in`;
  const text = plainLength(meters, unit, digits).replace("-", "−");
  return unit ? `${text} ${UNITS[unit].label}` : text;
}

/** How many digits a length deserves by its error: one beyond the error's first, at most six. */
export function digitsFor(error, unit) {
  const { perMeter, digits } = UNITS[unit] ?? { perMeter: 1, digits: 4 };
  if (!(error > 0)) return digits;
  const needed = Math.ceil(-Math.log10(error * perMeter));
  return Math.min(6, Math.max(digits, needed));
}

/** An error in the small unit that suits it; errors here are often nanometers. */
export function formatError(meters, unit) {
  if (!Number.isFinite(meters)) return "error unknown";
  const size = Math.abs(meters);
  if (!unit) return `± ${size.toPrecision(2)}`;
  if (unit === "in") {
    return size / INCH < 1e-4 ? "± under 0.0001 in" : `± ${rounded(size / INCH)} in`;
  }
  if (size < 1e-9) return "± under 1 nm";
  if (size < 1e-6) return `± ${rounded(size * 1e9)} nm`;
  if (size < 1e-5) return `± ${rounded(size * 1e6)} µm`;
  return size < 1e-2 ? `± ${rounded(size * 1e3)} mm` : `± ${rounded(size * 1e2)} cm`;
}

/** Two digits that count, without an exponent. */
function rounded(number) {
  const digits = Math.max(0, 1 - Math.floor(Math.log10(number)));
  return number.toFixed(Math.min(digits, 6));
}

/** The error of a measurement, which may also be an angle's, in degrees. */
export function formatErrorOf({ kind }, size, unit) {
  if (kind === "length" || !Number.isFinite(size)) return formatError(size, unit);
  if (kind === "angle") return size < 1e-3 ? "± under 0.001°" : `± ${rounded(size)}°`;
  return `± ${size.toPrecision(2)}`;
}

/** The value of a measurement, which may also be an angle or a ratio. */
export function formatValue(item, unit) {
  if (item.value === null || item.value === undefined || !Number.isFinite(item.value)) return "–";
  if (item.kind === "angle") return `${item.value.toFixed(1)}°`;
  if (item.kind === "ratio") return item.value.toFixed(4);
  return formatLength(item.value, unit);
}
