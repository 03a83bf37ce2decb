(** A graph that grows by what other processes have found of a state ({!Answers}). It is the same as if this
    process had found it. *)

module Make (L : Lts.S) : sig
  include module type of struct
    include Growing.Make (L)
  end

  val choose : t -> Shared_states.t -> int -> answer -> (int * bool) option
  (** [choose g shared i answer] is where the list of the edges of state [i] begins that is taken, and whether
      others are put off. It is [None] where the transitions have to be found by this process. *)

  val fetch : t -> answer -> unit
  (** [fetch g answer] looks up what {!grow_linked} asks for, so that it is fast. *)

  val grow_linked :
    t -> Limits.t -> Limits.surroundings -> visitor -> (unit -> told option) -> int -> Shared_states.t -> answer ->
    int * bool -> L.fault Statuses.reason option
    (** [grow_linked g limits around visitor expanded i shared answer list] expands state [i] by the list that
        {!choose} has chosen of the answer. [expanded ()] is the receiver of the results, if any. The result is
        what ends the exploration, if anything does. *)
end
