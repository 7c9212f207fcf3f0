// SPDX-License-Identifier: MIT
// The first page.
import { keepOffline } from "./offline.js";

keepOffline("sw.js");
