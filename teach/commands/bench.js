// A dot that is hovered or focused shows its figures and its pictures at once; the others step back.
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
  const pictures = (dot.dataset.pictures || "").split(" ").filter(Boolean);
  const show = () => {
    const row = document.createElement("div");
    for (const file of pictures) {
      const image = new Image();
      image.src = file;
      image.alt = "";
      image.onload = place;
      row.append(image);
    }
    tip.replaceChildren(row, figures);
    tip.hidden = false;
    dot.ownerSVGElement.classList.add("asked");
    place();
  };
  const place = () => {
    const box = dot.getBoundingClientRect();
    tip.style.left = `${Math.max(8, Math.min(box.right + 10, innerWidth - tip.offsetWidth - 8))}px`;
    tip.style.top = `${Math.max(8, Math.min(box.bottom + 8, innerHeight - tip.offsetHeight - 8))}px`;
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
