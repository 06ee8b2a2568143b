"use strict";

// One grasp at a time; all of them without JavaScript, and in print.
(() => {
  const choice = document.getElementById("grasp");
  const sections = [...document.querySelectorAll("section.grasp")];
  const show = () => {
    for (const section of sections) {
      section.classList.toggle("put-away", choice.value !== "" && section.id !== choice.value);
    }
  };
  choice.addEventListener("change", show);
  document.getElementById("grasp-choice").hidden = sections.length < 2;
  show();
})();
