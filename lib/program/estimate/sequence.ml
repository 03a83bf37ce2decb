let in_turn paths =
  match List.partition (fun (p : Path.t) -> Option.is_some p.horizon) paths with
  | (_ :: _ as timed), (_ :: _ as others) -> [ timed; others ]
  | _ -> [ paths ]

let of_paths aim (plan : Sample.plan) ~seed ~stopped paths =
  let estimation = Estimation.start aim paths in
  let run = Sample.run { plan with paths } ~seed ~interrupted:stopped in
  let rec make k ~count =
    if k >= count then true
    else if stopped () then false
    else begin
      Estimation.add estimation (run k);
      make (k + 1) ~count
    end
  in
  let rec go first =
    match Estimation.next estimation with
    | None -> ()
    | Some count ->
      let whole = make first ~count in
      Estimation.judge estimation ~last:(not whole);
      if whole then go count
  in
  go 0;
  Estimation.answers estimation

let answers aim (plan : Sample.plan) ~seed ~stopped =
  let found = List.concat_map (of_paths aim plan ~seed ~stopped) (in_turn plan.paths) in
  let of_path p = List.find_opt (fun (a : Estimation.answer) -> a.path == p) found in
  List.filter_map of_path plan.paths
