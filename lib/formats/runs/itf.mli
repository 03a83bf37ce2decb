(** Runs as traces in the Informal Trace Format of Apalache (JSON, [.itf.json]).

    Every number is exact and no JSON number: an integer is [{"#bigint": "5"}], and a rational the pair of
    numerator and denominator (positive, in lowest terms), [{"#tup": [{"#bigint": "1"}, {"#bigint": "2"}]}].
    Every state has every variable, and each variable is of one type in all states:

    {v
    action     what led here: the text of the label; "init" at first, "pass" in the midst of a passing of time
    time       model time
    position   from each leaf to the coordinates of its reference point, a tuple of three
    velocity   from each leaf to that of its process
    behaviour  from each leaf to its term, a text
    origin     from each leaf to the definition that its behaviour is or has aged from, or ""
    process    from each leaf to the first leaf of its process
    bonds      the set of bonds, each a record of a name and the features at its ends, one and two
    clock      from the first leaf of each process that may split to the time since its split clock was set
    step       a record of the time that remains of the movement step, and its phase: "none" without laws of
    motion
    v}

    A model in which weak splits are left to chance has two more:

    {v
    split_clock  from the first leaf of each process to the time since the last split instant of the network
    lots         the set of bonds whose lots are pending, each a pair of the bond, as in bonds, and of what is
                 decided: "undecided", "release" or "first"
    v}

    A rigid model has four more variables, or five:

    {v
    turned     from each leaf to how it is turned, a quaternion of integers w, x, y, z
    spin       from each leaf to that of its process
    since      from each leaf to how long ago the present turn of its process began
    lasts      from each leaf to how long that turn lasts in all, 0 if it does not spin; -1 while one is due to
               begin
    angular_momentum
               from each leaf to what its process keeps with [dynamics free_body]
    v} *)

open Scc_calculus

type t
(** A trace in the making. *)

val start : Model.t -> Scc_loading.Origin.t -> (string -> unit) -> t
(** Writes the beginning of the trace, up to its states. *)

val event : t -> Replay.event -> unit
(** Writes a state for each event except the last, which closes the trace. *)

val close : t -> unit
(** Closes a trace that has not ended, so that it can be read all the same. *)
