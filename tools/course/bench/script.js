// A dot that is hovered or focused tells its figures at once; the others step back.
const tip = document.createElement("div");
tip.className = "tip";
tip.setAttribute("role", "status");
tip.hidden = true;
document.body.append(tip);

for (const dot of document.querySelectorAll(".dot")) {
  const title = dot.querySelector("title");
  const figures = title.textContent;
  title.remove();
  dot.setAttribute("aria-label", figures);
  const show = () => {
    const box = dot.getBoundingClientRect();
    tip.textContent = figures;
    tip.hidden = false;
    tip.style.left = `${Math.max(8, Math.min(box.right + 10, innerWidth - tip.offsetWidth - 8))}px`;
    tip.style.top = `${Math.max(8, Math.min(box.bottom + 8, innerHeight - tip.offsetHeight - 8))}px`;
    dot.ownerSVGElement.classList.add("asked");
  };
  const hide = () => {
    tip.hidden = true;
    dot.ownerSVGElement.classList.remove("asked");
  };
  dot.addEventListener("pointerenter", show);
  dot.addEventListener("focus", show);
  dot.addEventListener("pointerleave", hide);
  dot.addEventListener("blur", hide);
}
