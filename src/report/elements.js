// Elements, numbers and steps, for all parts of the script. Texts of the study are only ever set as text,
// never as markup.

const byId = (id) => document.getElementById(id);

function svgElement(name, attributes, text) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  if (text !== undefined) made.textContent = text;
  return made;
}

/// The numbers of a row; null where it has none.
const numbers = (row, decimals) => row.split(",").map((text) => text === "" ? null : text / 10 ** decimals);
/// How many steps the slider shows as one; the last stretch may hold fewer.
const stepsOf = (data, step) => Math.min(data.length, data.steps - (step - 1) * data.length);
const rounded = (value, digits) => String(Number(value.toPrecision(digits)));
