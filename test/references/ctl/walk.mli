(** Runs followed step by step, and what they show of "f until g", by what holds in each cell. *)

open Scc_ctl
open Scc_exact

val rational : Algebraic.t -> Rat.t
val cell : Small.t -> Positions.position -> int option
(** The cell of an offset inside a flow; [None] at a node. *)

(** A piece of a run: an instant, or an open interval of elapsed time. *)
type piece = { position : Positions.position; from : Rat.t; until : Rat.t option  (** [None]: for ever *) }

val pieces : Small.t -> rounds:int -> Run.t -> (piece list, string) result
(** In order, or why it is no run of the graph. A cycle is gone round so many times. *)

type window = { low : Rat.t; high : Rat.t option }

val in_window : window -> piece -> bool
(** An open interval: some of it. *)

type verdict =
  | Met  (** g, within the window, with f before *)
  | Broken  (** f fails first *)
  | Past  (** neither happens before the end of the window *)
  | Open  (** neither happens *)

val until : window -> f:(Positions.position -> bool) -> g:(Positions.position -> bool) -> piece list -> verdict *
                                                                                                        piece list
(** With the pieces that come after the one that decides it. *)
