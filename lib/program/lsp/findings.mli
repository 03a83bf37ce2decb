(** What is shown beside a document: diagnostics with their fixes, values, and lenses. *)

open Scc_base
open Scc_json

val diagnostic : Session.t -> base:string option -> Positions.t -> Diag.t -> Json.t
(** A diagnostic in a text with these places. [base] is the path of the document that it was found for. *)

val of_verdict : Workspace.document -> Session.verdict -> Json.t option
(** The diagnostic of a verdict that is not that the property holds, at the name of its check. *)

val actions : Session.t -> Json.t -> Json.t
(** The changes that mend the diagnostics of a range. *)

val values : Session.t -> Json.t -> Json.t
(** The exact values of parameters and lets in a range, where they are not written there already. *)

val lenses : Session.t -> Json.t -> Json.t
(** Over each check: its verdict, and commands to decide it and to show a run. *)
