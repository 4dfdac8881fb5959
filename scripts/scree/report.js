// The animation of the fields: a slider over the output times, play and stop.
const animations = [...document.querySelectorAll(".animation")];
const images = [...document.querySelectorAll(".animation img")];
const slider = document.getElementById("time");

function show() {
  if (!slider) return;
  const frame = Number(slider.value);
  for (const animation of animations) {
    [...animation.querySelectorAll("img")].forEach((image, k) => image.classList.toggle("shown", k === frame));
  }
  document.getElementById("shown_time").value = `t = ${slider.dataset.times.split(" ")[frame]} s`;
}

let playing = null;

function play() {
  const button = document.getElementById("play");
  if (playing) {
    clearInterval(playing);
    playing = null;
  } else {
    playing = setInterval(() => {
      slider.value = slider.value === slider.max ? 0 : Number(slider.value) + 1;
      show();
    }, 150);
  }
  button.textContent = playing ? "Stop" : "Play";
}

if (slider) {
  slider.addEventListener("input", show);
  document.getElementById("play").addEventListener("click", play);
  show();
}

// How many frames the browser could decode, for those who check the page.
window.addEventListener("load", () => {
  document.body.dataset.frames = images.filter((image) => image.complete && image.naturalWidth > 0).length;
});
