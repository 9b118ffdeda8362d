// Words and numbers of the page.

export function number(value, digits = 3) {
  if (value === null || value === undefined) {
    return "–";
  }
  if (value === 0) {
    return "0";
  }
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
}

/// With so many digits, and no minus before a zero.
export function fixed(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

export function seconds(value) {
  return value === null ? "never" : `${value.toFixed(value < 10 ? 1 : 0)} s`;
}

/// "disarmed, no gains yet"; empty for none.
export function faultNames(robot, bits) {
  return robot.faults.filter((_, bit) => bits & (1 << bit)).join(", ");
}


/// "bad", "warning" or "" for a set of faults.
export function weight(robot, bits) {
  if (robot.failures.some((failed, bit) => failed && bits & (1 << bit))) {
    return "bad";
  }
  return bits ? "warning" : "";
}

/// Sets text only where it changed: a page that is read aloud must not be told the same twenty times a second.
export function say(element, text) {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}

export function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

/// Fills a list of names and values, keeping its elements.
export function fill(list, entries) {
  while (list.children.length < entries.length) {
    list.append(make("div", {}, make("dt"), make("dd")));
  }
  while (list.children.length > entries.length) {
    list.lastElementChild.remove();
  }
  entries.forEach(([name, value], i) => {
    say(list.children[i].children[0], name);
    say(list.children[i].children[1], value);
  });
}
