// What the reader chose, kept over a reload.
"use strict";

const place = `cpt-report:${location.pathname}:`;
function kept(name, otherwise) {
  try {
    const text = sessionStorage.getItem(place + name);
    return text === null ? otherwise : JSON.parse(text);
  } catch {
    return otherwise;
  }
}
function keep(name, value) {
  try {
    sessionStorage.setItem(place + name, JSON.stringify(value));
  } catch {
    // Private windows may refuse; the page works without.
  }
}
