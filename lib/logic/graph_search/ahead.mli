(** A graph whose states are shared with other processes: they find the transitions of states ahead of the process
    that numbers states, and put them into {!Answers}. *)

module Make (L : Lts.S) : sig
  include module type of struct
    include Explored_graph.Make (L)
  end

  val put_answer : t -> all_edges:bool -> dull:(int array -> bool) -> Answers.words -> int -> int -> int
  (** [put_answer g ~all_edges ~dull words at i] puts the transitions of state [i] into [words] from [at] on. The
      result is the first place that is free after that. Without [all_edges], edges that change nothing may be left
      out. [dull] is true of the tuples of new states that no visitor needs. It raises {!Answers.Too_long}
      if there is no room. *)

  (** {1 Sharing} *)

  val share : t -> Common.t option
  (** [share g] lets processes that are forked from now on see the states; [None] if the system gives no memory. *)

  val unshare : t -> unit
  (** [unshare g] moves the tables back to this process alone. *)

  val shared_bytes : t -> int
  (** [shared_bytes g] is about how much memory is shared. *)

  val refresh : t -> Common.t -> unit
  (** [refresh g common] is called by a process that has not worked for a while. *)

  val is_room_wanted : t -> Common.t -> bool
  (** [is_room_wanted g common] is true if {!make_room} should be called soon. *)

  val make_room : t -> Common.t -> unit
  (** [make_room g common] enlarges what is full, while no other process uses it. *)

  val go_on_apart : t -> Common.t -> full:(unit -> unit) -> unit
  (** [go_on_apart g common ~full] is called by a forked process before {!put_answer}. [full] is as for
      {!set_full}. *)

  val set_full : t -> Common.t -> (unit -> unit) -> unit
  (** [set_full g common full]: this process calls [full] where something does not fit the tables. *)
end
