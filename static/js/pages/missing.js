/** The page that says that there is no such page. */

import { startPage } from "../page.js";

startPage(() => {});
