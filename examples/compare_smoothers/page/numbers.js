// SPDX-License-Identifier: GPL-3.0-or-later
// The table, and what its columns mean.

const columns = {
  "rms": ["rms error", "root mean square distance to the true surface", true],
  "edge rms": ["near edges", "the same, of the points near sharp edges", true],
  "signed mean": ["mean error", "mean signed distance: negative where the cloud has shrunk", true],
  "drift": ["drift", "rms movement within the surface, which spoils the spacing", true],
  "movement": ["movement", "rms movement", false],
  "roughness": ["roughness", "rms distance to the plane of 18 neighbors: noise, and curvature", false],
  "normal deg": ["normals, deg", "mean angle to the true normals, in degrees", true],
  "seconds": ["seconds", "time of the run", true],
  "MB": ["MB", "peak memory above that at the start", true],
};

const element = (name, text = "", properties = {}) =>
  Object.assign(document.createElement(name), { textContent: text }, properties);

const shown_title = title => title === "none" ? "noisy, as given" : title;

/// The table's cell of a row and a column by its name; not a number if it has none or is empty
function number_of({ columns: names, rows }, title, column) {
  const row = rows.find(([name]) => name === title), at = names.indexOf(column);
  return row && at > 0 && row[at] !== null ? row[at] : NaN;
}

function write_numbers(data) {
  const names = Object.keys(columns).filter(name => data.columns.includes(name) &&
    !(name === "roughness" && data.noise !== null));
  const table = document.getElementById("numbers"), list = document.getElementById("columns");
  const head = table.createTHead().insertRow(), body = table.createTBody();
  head.append(element("th", "method", { scope: "col" }),
    ...names.map(name => element("th", columns[name][0], { scope: "col", title: columns[name][1] })));
  const methods = data.rows.map(([title]) => title).filter(title => title !== "none");
  const best = name => Math.min(...methods.map(title => Math.abs(number_of(data, title, name)))
    .filter(number => !isNaN(number)));
  for (const [title] of data.rows) {
    const row = body.insertRow();
    row.append(element("th", shown_title(title), { scope: "row" }));
    for (const name of names) {
      const is_run = title !== "none" || !(name === "seconds" || name === "MB");
      const number = is_run ? number_of(data, title, name) : NaN;
      const is_best = columns[name][2] && title !== "none" && methods.length > 1 &&
        Math.abs(number) === best(name);
      row.append(element("td", isNaN(number) ? "\u2013" : short(number).replace("-", "\u2212"),
        { className: is_best ? "best" : "" }));
    }
  }
  for (const name of names)
    list.append(element("dt", columns[name][0]), element("dd", columns[name][1]));
  list.append(element("dt", "lengths"), element("dd", `in thousandths of the radius of the data, ${
    short(data.radius)} in their unit. The best number of the methods is bold.`));
}
