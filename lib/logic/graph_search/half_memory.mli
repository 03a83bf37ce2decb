(** What a half of a tuple is after each of some changes, for halves that were asked about last: see {!Tuples}.

    Transitions of two states that have a half in common mostly come in the same order, as far as they change that
    half alone. So only what came after the one that was asked for last is looked at. *)

type t

val create : unit -> t

val start : t -> int -> unit
(** The half that the following is about, by its number. *)

val find : t -> int array -> int
(** Its number after the changes, if they came next the last time; -1 if that is not remembered. Changes are
    recognised as the same array. *)

val keep : t -> int array -> int -> unit
(** Of the changes that {!find} did not know; any number but -1. *)
