// Opens the viewer that this page carries when its place comes into sight, and lets it show what
// a link names.
(() => {
  const frame = document.getElementById("scene-frame");
  const place = document.getElementById("scene");
  let wanted = null;
  let ready = false;

  const show = () => {
    if (ready && wanted) frame.contentWindow.postMessage({ bodymeasure: "show", ...wanted }, "*");
  };

  async function open() {
    try {
      const text = atob(document.getElementById("scene-page").textContent);
      const bytes = new Uint8Array(text.length);
      for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
      const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
      frame.srcdoc = await new Response(stream).text();
    } catch {
      place.querySelector(".trouble").hidden = false;
    }
  }

  addEventListener("message", (event) => {
    if (event.source !== frame.contentWindow || event.data?.bodymeasure !== "ready") return;
    ready = true;
    frame.dataset.ready = "";
    show();
  });
  document.addEventListener("click", (event) => {
    const link = event.target.closest("[data-show]");
    if (!link) return;
    wanted = JSON.parse(link.dataset.show);
    show();
  });
  document.documentElement.classList.add("scripted");
  new IntersectionObserver((entries, observer) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    observer.disconnect();
    open();
  }).observe(frame);
})();
