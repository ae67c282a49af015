// One keyboard for the whole page, except where something is being typed or chosen.
export function listenToKeys({ store, timeline, frames, view, nextColour, toggleBox, toggleDark }) {
  const turn = Math.PI / 24;
  const withShift = {
    ArrowLeft: () => view()?.turn(-turn, 0), ArrowRight: () => view()?.turn(turn, 0),
    ArrowUp: () => view()?.turn(0, -turn), ArrowDown: () => view()?.turn(0, turn),
  };
  const plain = {
    " ": () => timeline.toggle(),
    ArrowLeft: () => timeline.pauseAt(store.get("frame") - 1), ArrowRight: () => timeline.pauseAt(store.get("frame") + 1),
    Home: () => timeline.pauseAt(0), End: () => timeline.pauseAt(frames().length - 1),
    c: nextColour, b: toggleBox, d: toggleDark, r: () => view()?.look("fit"),
    "-": () => view()?.zoom(1.12),
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target;
    const tag = target.tagName;
    if (tag === "SELECT" || tag === "TEXTAREA" || (tag === "INPUT" && target.type !== "range")) return;
    if (tag === "INPUT" && event.key !== " " && !event.shiftKey) return; // the slider has its own arrows
    if (event.key === " " && (tag === "BUTTON" || tag === "SUMMARY" || tag === "A")) return;
    // Scrolling by arrows, home and end stays where a table or a text is in focus.
    if (target.closest?.(".scroll, pre") && event.key !== " ") return;
    const act = event.key === "+" || event.key === "=" ? () => view()?.zoom(1 / 1.12) : event.shiftKey ? withShift[event.key] : plain[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}
