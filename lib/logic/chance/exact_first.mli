(** Exact values where there is time for them, and intervals otherwise. *)

val run :
  Effort.t ->
  exactly:(Effort.t -> ('a, Lifting.given_up) result) ->
  nearly:(Effort.t -> 'a) ->
  enough:('a -> bool) ->
  'a
(** [run effort ~exactly ~nearly ~enough] is what [exactly] finds, or else what [nearly] finds. When a quarter
    of the time is over, [nearly] is called while [exactly] waits. If that took less than half of the rest, and is
    not [enough], [exactly] goes on for half of what is then left, so that nothing is done twice. If it gives up,
    [not_exact] is told why. *)
