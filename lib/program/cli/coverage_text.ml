open Scc_verify
open Scc_reports

let section heading = function
  | [] -> []
  | names -> (heading ^ ":") :: List.map (fun name -> "  " ^ name) names

let unused (c : Coverage.channel) = c.made = 0 && c.weak = 0 && c.strong = 0

let rule_counts c =
  let count (r, n) = Printf.sprintf "%s %d" (Scc_semantics.Rule.id r) n in
  match List.partition (fun (_, n) -> n > 0) (Coverage.rules c) with
  | [], _ -> [ "no rule was ever used" ]
  | used, never ->
    let never_used = List.map (fun (r, _) -> Scc_semantics.Rule.id r) never in
    ("rules: " ^ String.concat ", " (List.map count used))
    :: (match never_used with [] -> [] | _ :: _ -> [ "rules never used: " ^ String.concat ", " never_used ])

let lines console (s : Explored.t) c =
  let m = Explored.model s in
  let summands = Coverage.summands c and behaviours = Coverage.behaviours c in
  let channels = Coverage.channels c in
  let idle = List.filter (fun (x : Coverage.summand) -> x.fired = 0) summands in
  let unreached = List.filter (fun (b : Coverage.behaviour) -> not b.reached) behaviours in
  let unused = List.filter unused channels in
  let part all missing what =
    let n = List.length all in
    Printf.sprintf "%d of %d %s" (n - List.length missing) n what
  in
  let counts =
    String.concat ", "
      [
        part summands idle "summands fired";
        part behaviours unreached "behaviours reached";
        part channels unused "channels used";
      ]
  in
  let style : Console.style =
    match (idle, unreached, unused) with [], [], [] -> Good | _, _, _ -> Doubtful
  in
  let among =
    let looked_at = Coverage.looked_at c and states = if s.size = 1 then "state" else "states" in
    if looked_at = s.size then Printf.sprintf "among %d %s" s.size states
    else
      Printf.sprintf "among the transitions of %d of the %d %s found: more may fire beyond the bounds" looked_at
        s.size states
  in
  let summand x = Printf.sprintf "%s: %s" (Coverage_json.owner m x) (Coverage_json.term m x) in
  let details =
    section "never fired" (List.map summand idle)
    @ section "never reached" (List.map (Coverage_json.behaviour m) unreached)
    @ section "channels never used" (List.map (fun (x : Coverage.channel) -> x.name) unused)
    @ rule_counts c
  in
  Printf.sprintf "coverage: %s, %s\n" (Console.styled console style counts) among
  ^ String.concat "" (List.map (fun l -> "  " ^ l ^ "\n") details)
