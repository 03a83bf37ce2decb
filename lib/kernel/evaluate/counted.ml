type t = { least : int; most : int }

let none = { least = 0; most = 0 }

let by semantics ~source label p =
  let truth happening =
    let arrived = Event.matches ~source happening in
    (Trajectory.prop (Trajectory.make ~arrived semantics source Scc_ctl.Timeline.Instant) p).start
  in
  let add n happening =
    match truth happening with
    | Scc_ctl.Truth.True -> { least = n.least + 1; most = n.most + 1 }
    | Undecided _ -> { n with most = n.most + 1 }
    | False -> n
  in
  List.fold_left add none (Event.each label)
