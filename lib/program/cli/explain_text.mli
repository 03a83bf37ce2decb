(** What a fact depends on, in words. *)

open Scc_property
open Scc_explain

val lines : Console.t -> full:bool -> Property.check option -> Scc_exchange.Replay.ending -> Omission.t -> string
(** The fact, the steps of the run ([*] marks those that it depends on, each with its reasons; of those between
    them it is told in a line how many there are, unless [full]), its end if it is a dead end, and what was tried
    without bodies that seem not to matter. *)
