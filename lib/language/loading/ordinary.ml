open Scc_base
open Scc_calculus

let on_grid (l : Loaded.t) =
  match l.model.splits with
  | Any_time when Parameters.may_split l.model l.declared ->
    Error
      [
        Diag.error Code.any_time Span.none
          "bonds of this model may be released at any time (`split_step any`), and this looks at the instants of \
           a grid"
          ~hint:"`scc check` answers for all instants, and `scc trace` shows single runs; or give a `split_step`";
      ]
  | Any_time | Every _ -> Ok ()

let most_named = 5

let at_point ?otherwise (l : Loaded.t) =
  match Array.to_list l.model.ranges with
  | [] -> Ok ()
  | ranges ->
    let named = List.filteri (fun i _ -> i < most_named) ranges in
    let names = List.map (fun (r : Ranges.range) -> Printf.sprintf "`%s`" r.name) named in
    let more = if List.length ranges > most_named then ", …" else "" in
    let example = (List.hd ranges).name in
    let otherwise = match otherwise with None -> "" | Some words -> "; " ^ words in
    Error
      [
        Diag.error Code.not_known Span.none "this needs the values of all parameters, and of %s%s a range is known"
          (String.concat ", " names) more
          ~hint:(Printf.sprintf "`scc check` answers for all values; `-D %s=VALUE` gives one%s" example otherwise);
      ]

let has_ranges (l : Loaded.t) =
  if Array.length l.model.ranges > 0 then Ok ()
  else
    Error
      [
        Diag.error Code.bad_value Span.none "no parameter of this model has a range"
          ~hint:"`param x in [0, 6]` declares one, `-D 'x=[1,3]'` narrows it, and `-D x=2` leaves a value alone";
      ]

let refuse l = Result.bind (at_point l) (fun () -> Result.map (fun () -> l) (on_grid l))
