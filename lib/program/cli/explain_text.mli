(** The causes of a fact, as text. *)

open Scc_property
open Scc_explain

val lines : Console.t -> full:bool -> Property.check option -> Scc_runs.Replay.ending -> Omission.t -> string
(** The fact, the steps of the run, its end if it is a dead end, and the attempts without bodies that seem
    irrelevant. [*] marks the steps on which the fact depends, each with its reasons. The steps between them are
    counted in one line, unless [full]. *)
