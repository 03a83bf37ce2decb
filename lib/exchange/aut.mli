(** The Aldebaran format of labelled transition systems, for CADP, mCRL2 and merc. It has no comments and no labels of
    states. A state whose transitions are not known gets a loop [unexplored], and one in which nothing will ever happen again a loop
    [time(forever)]. *)

open Scc_verify

(** How the invisible action is written. *)
type tau =
  | Tau  (** ["tau"] (mCRL2, merc) *)
  | Cadp  (** [i], without quotes *)

val label : string -> string
(** A label's text between quotes. Quotes within it become ['], and control characters spaces, since readers know of no
    escapes. *)

val write : tau -> hidden:(string -> bool) -> Space.t -> (string -> unit) -> unit
(** [hidden] tells by a label's text whether it is invisible. *)
