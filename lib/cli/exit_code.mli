(** The exit codes, the same for every command. *)

type t =
  | Holds  (** 0: all is well *)
  | Violated  (** 1: some property is violated *)
  | Undecided  (** 2: something is undecided, a default bound that truncates included *)
  | Invalid  (** 3: the model or another input is invalid *)
  | Stopped  (** 4: a resource limit or an interruption *)
  | Usage  (** 64: the command line is wrong *)
  | Bug  (** 70: a fault of scc itself *)

val to_int : t -> int

val worst : t list -> t
(** The code of a run in which several apply: a bug, a wrong command line or an invalid input first, then
    1, 4, 2 and 0. *)

val man : Cmdliner.Cmd.Exit.info list
(** For the manual pages. *)
