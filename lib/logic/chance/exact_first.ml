let run (effort : Effort.t) ~exactly ~nearly ~enough =
  let first_part = effort.quarter () in
  let found = ref None and second = ref None in
  let is_over part = part () || effort.interrupted () in
  (* What asks whether it is interrupted waits meanwhile. *)
  let begin_second () =
    let quickly = effort.half () in
    let x = nearly effort in
    found := Some x;
    if enough x || is_over quickly then Fun.const true else effort.half ()
  in
  let interrupted () =
    match !second with
    | Some part -> is_over part
    | None when not (is_over first_part) -> false
    | None when effort.interrupted () -> true
    | None ->
      let part = begin_second () in
      second := Some part;
      is_over part
  in
  match exactly { effort with interrupted } with
  | Ok x -> x
  | Error why ->
    effort.not_exact why;
    (match !found with Some x -> x | None -> nearly effort)
