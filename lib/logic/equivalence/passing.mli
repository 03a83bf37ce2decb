(** Graphs in which time passes: labels that {!Label.passing} knows. *)

val merge : Graph.t -> Graph.t
(** Consecutive passings of time that nothing observes become one: a state at which nothing can happen but one
    passing of time is only a place on the way, since time is additive ([time(1).time(2) = time(3)]). A way
    that passes time for ever without anything else is [time(forever)], to a state that has
    no other move than that. The initial state stays, and
    is state 0; states that are not reached any more are dropped. Labels of time that mean the same duration
    become one. A loop of silent or other labels is something that can happen. *)

val deterministic : Graph.t -> bool
(** No state has two different passings of time. *)

val hide : Graph.t -> Graph.t
(** Every passing of time becomes silent. *)

val without_durations : Graph.t -> Graph.t
(** Every passing of time becomes the action [time]. *)
