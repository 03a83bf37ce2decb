(** Who collides now, and what may come of it, by number: thousands may collide at one instant, and each collision
    that happens changes the few that its bodies are in. Pairs are in the order of their first leaves, and the
    outcomes of each in the order in which they were found. *)

type ('body, 'outcome) t

val create : int -> first:('body -> int) -> age:('body -> int) -> ('body, 'outcome) t
(** Of a network of so many leaves, in which nobody collides. [first]: the first leaf of a body, which tells it
    from all others. [age]: a number that changes whenever the body does. *)

val meet : ('body, 'outcome) t -> 'body -> 'body -> unit
(** The two collide, the one with the lesser first leaf first; nothing happens if that is known. This and what
    follows takes O(log n) steps for n pairs, for each pair that it is about. *)

val part : ('body, 'outcome) t -> int -> unit
(** The body with this first leaf takes another course: it collides with nobody. *)

val changed : ('body, 'outcome) t -> int -> unit
(** The body with this first leaf may have changed, on its course. *)

val find : ('body, 'outcome) t -> ('body -> 'body -> 'outcome list) -> unit
(** Finds the outcomes of the pairs that have met, and again of those in which one has changed. *)

val count : ('body, 'outcome) t -> int
(** How many outcomes there are, as they were found last. *)

val nth : ('body, 'outcome) t -> int -> 'outcome
(** By its number, from 0 (a bug when there is none). *)

val bodies : ('body, 'outcome) t -> 'body list
(** All that collide, in order: takes O(n). *)
