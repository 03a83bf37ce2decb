(** How far an exploration has come. All owners have the same, at the end of each level. *)

open Scc_codec

(** When a goal is met, in the order of a single search: at a rank of the level that is expanded; by a new state,
    or ahead of the expanded one; and by which transition. And which state shows it. *)
type event = { rank : int; ahead : bool; choice : int; owner : int; id : int }

(** A state: its level, its owner, and its number there. *)
type place = { level : int; owner : int; id : int }

(** Why an exploration ends before everything is found: all is decided, it meets the bound of states or that of
    transitions without duration, or no property depends on what comes later. *)
type stop = Early | States | Levels | Late

type t = {
  level : int;
  depth : int;  (** of the deepest state *)
  width : int;  (** states of the last level *)
  states : int;
  transitions : int;
  met : place option array;  (** by goal *)
  doubts : bool array;  (** goals that are undecided in some state *)
  open_ : bool array option;
  (** goals that may be met after states that were not expanded; [None]: all that are not met, if there are any
      such states *)
  stop : stop option;
  faults : string list;  (** in order, each once *)
  ends : string list;  (** likewise, why runs are given up *)
  too_long : int;  (** states that are not expanded since a number is too long *)
  too_deep : int;  (** states that are not expanded after too many transitions without duration *)
}

val stop_name : stop -> string
(** The reason in a word. *)

val earlier : event option -> event option -> event option
(** The first of the events that are there. *)

val is_time_to_look : before:t -> t -> bool
(** [is_time_to_look ~before p] is true if there are twice as many states as when this was so the last time: all
    goals are met, and it is worth while to see whether more states matter to other properties. *)

val add : string list -> string list -> string list
(** [add texts more] is both, in order, each once. *)

(** {1 As bytes} *)

val put : Buffer.t -> t -> unit
(** Appends the bytes of an exploration that goes on. *)

val read : Packed.source -> t
(** Reads the bytes of {!put}. Raises [Packed.Malformed]. *)

val put_texts : Buffer.t -> string list -> unit
(** Appends texts, for [Packed.list] of [Packed.text]. *)

val put_option : Buffer.t -> (Buffer.t -> 'a -> unit) -> 'a option -> unit
(** Appends a value that may not be there. *)

val read_option : Packed.source -> (Packed.source -> 'a) -> 'a option
(** Reads such a value. *)

val put_bool : Buffer.t -> bool -> unit
(** Appends a truth value. *)

val read_bool : Packed.source -> bool
(** Reads a truth value. *)
