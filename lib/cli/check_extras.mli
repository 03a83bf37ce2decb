(** What [scc check] tells or writes when it is asked to, besides its verdicts. *)

type t = {
  witness : string option;  (** a folder for schedules *)
  coverage : bool;
  stats : bool;
  sarif : string option;  (** a file *)
}

val term : t Cmdliner.Term.t
