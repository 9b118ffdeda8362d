// What is looked from: an opening that the page's controls and the worker's camera share.
export const kAngle_deg = 38;
