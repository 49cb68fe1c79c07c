// Clips of several shapes over a thick stroke, whose box without the stroke is narrower than what is seen of it.

/** What is clipped: a stroke of 60 units from (50, 30) to (50, 170). */
const STROKE = '<path d="M50 30V170" stroke="#3f9fc0" stroke-width="60" fill="none"';

/** Shapes of clips, each in a cell of 100 units, with points `[x, y, true if the stroke is seen]`. */
export const CELLS = [
  ["<rect x='10' y='40' width='35' height='100'/><rect x='45' y='80' width='45' height='100'/>", [25, 60, true], [75, 60, false], [75, 120, true], [25, 160, false]],
  ["<rect x='10' y='40' width='50' height='30'/><circle cx='50' cy='120' r='40'/>", [25, 60, true], [75, 60, false], [25, 120, true], [75, 120, true], [24, 155, false]],
  ["<ellipse cx='50' cy='60' rx='45' ry='20'/><rect x='20' y='100' width='60' height='60' rx='25'/>", [25, 60, true], [75, 60, true], [50, 90, false], [50, 130, true], [23, 103, false]],
  // Outlines in opposite directions that overlap.
  ["<path d='M15 40H85V120H15Z'/><path d='M15 80V160H85V80Z'/>", [25, 60, true], [75, 100, true], [25, 100, true], [75, 150, true], [25, 166, false]],
  ["<polygon points='15,40 85,40 50,110'/><rect x='15' y='60' width='70' height='20'/><path d='m15 120v40h70v-40z'/>", [30, 45, true], [75, 70, true], [40, 70, true], [25, 100, false], [75, 140, true]],
  ["<rect repeat='i in 0..2' x='10' y='{40 + 40*i}' width='80' height='20'/>", [25, 50, true], [75, 50, true], [25, 70, false], [75, 90, true], [25, 130, true], [75, 150, false]],
  // Of negative height at the start, and not drawn.
  ["<rect x='10' y='100' width='80' height='{40*y/h}'/><rect x='10' y='40' width='80' height='80'/>", [25, 60, true], [75, 90, true], [25, 110, true], [75, 135, false]],
].map(([shapes, ...points]) => ({ shapes, points }));

/** A document with all cells side by side. */
export function clips() {
  const cell = ({ shapes }, place) =>
    `  <g transform="translate(${100 * place} 0)"><clipPath id="c${place}">${shapes}</clipPath><g clip-path="url(#c${place})">${STROKE}/></g></g>`;
  return [
    "---\ntitle: Clips\nlanguage: en\n---\n\n```model\nparameter h = 1 [m]\ny'' = -y*1 [1/s^2]\ny(0) = -h\ny'(0) = 0\n```\n\n```scene",
    `<svg viewBox="0 0 ${100 * CELLS.length} 200">`,
    ...CELLS.map(cell),
    "</svg>\n```\n",
  ].join("\n");
}
