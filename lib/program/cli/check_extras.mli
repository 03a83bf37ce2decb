(** What [scc check] tells or writes when it is asked to, besides its verdicts, and how it explores. *)

type t = {
  witness : string option;  (** a folder for schedules *)
  coverage : bool;
  stats : bool;
  sarif : string option;  (** a file *)
  reductions : Scc_state_space.Reduction.kind list;
  order : Scc_state_space.State_graph.order;
  compact : bool;  (** hash compaction *)
  where : bool;  (** for which values of the parameters *)
  smt : string option;  (** a file for that *)
  draw : string option;  (** a file for a picture of that *)
  axes : string list;  (** the parameters to draw *)
  slice : (string * Scc_exact.Rat.t) list;  (** values of others there *)
  prove : bool;  (** look for an invariant first *)
  invariant : string option;  (** a file for it *)
  full : bool;  (** runs with all there is *)
  jobs : int option;  (** processes; [None]: as many as help *)
  store : string option;  (** a folder *)
}

val term : t Cmdliner.Term.t

val explored : t -> Scc_session.Budget.t -> (string * string) list
(** By their names, the options on which a graph depends, or which graphs there are, without those that end the
    work before it is done. *)

val reductions : Scc_state_space.Reduction.kind list Cmdliner.Term.t
(** [--no-reduce]. *)
