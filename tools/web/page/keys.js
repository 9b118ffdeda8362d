// What keys do. Fields that need a key themselves keep it.

/// act: joint(step), leg(step), joint ends, pause(), step(frames)
export function listenToKeys(act, help) {
  const toggleHelp = () => (help.open ? help.close() : help.showModal());
  document.getElementById("help-button").addEventListener("click", toggleHelp);
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    const target = event.target;
    const field = target.matches("input, select, textarea");
    const scrolls = target.id === "events" && ["ArrowUp", "ArrowDown", "Home", "End"].includes(event.key);
    const presses = event.key === " " && target.matches("button");
    const keys = {
      "?": toggleHelp,
      " ": act.pause,
      ",": () => act.step(-1),
      ".": () => act.step(1),
      ArrowLeft: () => act.joint(-1),
      ArrowRight: () => act.joint(1),
      ArrowUp: () => act.leg(-1),
      ArrowDown: () => act.leg(1),
      Home: () => act.end(0),
      End: () => act.end(Infinity),
    };
    const arrow = event.key.startsWith("Arrow") || event.key === "Home" || event.key === "End";
    if (!(event.key in keys) || (help.open && event.key !== "?") || (field && (arrow || event.key === ".")) ||
        scrolls || presses) {
      return;
    }
    event.preventDefault();
    keys[event.key]();
  });
}
