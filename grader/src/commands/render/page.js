// Asks whether there is a better picture, and shows each as large as the last one will be.
const [picture, says, remarks, error] = ["picture", "says", "remarks", "error"].map(id => document.getElementById(id));
let number = 0;

async function renew() {
  try {
    const state = await (await fetch("state.json", { cache: "no-store" })).json();
    if (state.number !== number) {
      picture.src = `picture.png?number=${state.number}`;
      picture.width = state.width;
      picture.hidden = false;
      says.textContent = state.says;
    }
    number = state.number;
    remarks.textContent = state.remarks;
    remarks.hidden = !state.remarks;
    error.textContent = state.error ?? "";
    error.hidden = !state.error;
    picture.classList.toggle("old", Boolean(state.error));
    setTimeout(renew, 300);
  } catch {
    says.textContent += " The command has ended.";
  }
}
renew();
