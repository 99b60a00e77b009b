// Tables that are sorted by clicking a column's heading.

const collator = new Intl.Collator(undefined, {numeric: true});

function sortBy(table, column, ascending) {
  const body = table.tBodies[0];
  const isNumber = table.tHead.rows[0].cells[column].classList.contains("n");
  const keyed = [...body.rows].map((row) => {
    const text = row.cells[column].textContent;
    return {row, text, number: parseFloat(text)};
  });
  const order = ascending ? 1 : -1;
  keyed.sort((a, b) => {
    if (!isNumber) return order * collator.compare(a.text, b.text);
    if (isNaN(a.number) || isNaN(b.number)) return isNaN(a.number) - isNaN(b.number);  // none stand last
    return order * (a.number - b.number);
  });
  body.append(...keyed.map((item) => item.row));
}

/// A second click on a heading turns the order round.
function makeSortable() {
  for (const table of document.querySelectorAll("table.sortable")) {
    const heads = [...table.tHead.rows[0].cells];
    heads.forEach((head, column) => head.firstElementChild.addEventListener("click", () => {
      const ascending = head.getAttribute("aria-sort") !== "ascending";
      heads.forEach((other) => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", ascending ? "ascending" : "descending");
      sortBy(table, column, ascending);
    }));
  }
}
