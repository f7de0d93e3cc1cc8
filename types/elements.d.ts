/** The custom elements of the pages, so that `el("robot-scene")` and `querySelector("robot-scene")` know them. */
import type { DhTableEditor } from "../static/js/editor/dh-table-editor.js";
import type { JointSliders } from "../static/js/joint-sliders.js";
import type { MatrixPanel } from "../static/js/matrix-panel.js";
import type { RobotScene } from "../static/js/scene/robot-scene.js";

declare global {
  interface HTMLElementTagNameMap {
    "dh-table-editor": DhTableEditor;
    "joint-sliders": JointSliders;
    "matrix-panel": MatrixPanel;
    "robot-scene": RobotScene;
  }
}
