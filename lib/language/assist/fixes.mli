(** Changes that mend what a diagnostic reports, from its hint. *)

open Scc_base
open Scc_describe

(** A change of a text. *)
type t = { title : string;  (** what is done, as a command *) edits : Rename.edit list }

val of_diagnostic : Reading.t -> Diag.t -> t list
(** The changes that a diagnostic of this text suggests, the best first. Most have none. *)

val of_diagnostics : Reading.t -> Diag.t list -> (Diag.t * t) list
(** The changes that the diagnostics suggest, in their order. What several suggest, as those of all members of a
    family do, is there once, with the first. *)
