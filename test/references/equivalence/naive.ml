open Scc_equivalence
open Scc_exact

let make ?(unknown = []) size edges =
  let b = Graph.builder () in
  List.iter (fun (source, label, target) -> Graph.add b ~source ~label:(Graph.intern b label) ~target) edges;
  Graph.finish b ~size ~initial:0 ~unknown:(fun s -> List.mem s unknown)

let edges (g : Graph.t) =
  let found = ref [] in
  for s = 0 to g.size - 1 do
    Graph.iter g s (fun l t -> found := (s, g.labels.(l), t) :: !found)
  done;
  List.rev !found

type relation = Strong | Branching | Weak

let bisimilar relation (g : Graph.t) =
  let n = g.size in
  let edges = edges g in
  let step s = List.filter_map (fun (a, l, b) -> if a = s then Some (l, b) else None) edges in
  let out = Array.init n step in
  (* tau* as a matrix *)
  let silent = Array.init n (fun i -> Array.init n (fun j -> i = j)) in
  List.iter (fun (a, l, b) -> if l = "tau" then silent.(a).(b) <- true) edges;
  for k = 0 to n - 1 do
    for i = 0 to n - 1 do
      for j = 0 to n - 1 do
        if silent.(i).(k) && silent.(k).(j) then silent.(i).(j) <- true
      done
    done
  done;
  let all = List.init n Fun.id in
  let r = Array.make_matrix n n true in
  let answered s t (l, s') =
    match relation with
    | Strong -> List.exists (fun (m, t') -> m = l && r.(s').(t')) out.(t)
    | Weak ->
      if l = "tau" then List.exists (fun t' -> silent.(t).(t') && r.(s').(t')) all
      else
        List.exists
          (fun (t1, m, t2) ->
             m = l && silent.(t).(t1) && List.exists (fun t3 -> silent.(t2).(t3) && r.(s').(t3)) all)
          edges
    | Branching ->
      (l = "tau" && r.(s').(t))
      || List.exists
        (fun (t1, m, t2) -> m = l && silent.(t).(t1) && r.(s).(t1) && r.(s').(t2))
        edges
  in
  let changed = ref true in
  while !changed do
    changed := false;
    List.iter
      (fun s ->
         List.iter
           (fun t ->
              if
                r.(s).(t)
                && not (List.for_all (answered s t) out.(s) && List.for_all (answered t s) out.(t))
              then begin
                r.(s).(t) <- false;
                r.(t).(s) <- false;
                changed := true
              end)
           all)
      all
  done;
  r

let side_by_side g (h : Graph.t) =
  let n = (g : Graph.t).size in
  make (n + h.size) (edges g @ List.map (fun (s, l, t) -> (s + n, l, t + n)) (edges h))

let related relation g h = (bisimilar relation (side_by_side g h)).(0).((g : Graph.t).size)

let traces depth g =
  let edges = edges g in
  let rec close set =
    let more =
      List.filter_map
        (fun (s, l, t) -> if l = "tau" && List.mem s set && not (List.mem t set) then Some t else None)
        edges
    in
    if more = [] then set else close (List.sort_uniq compare (more @ set))
  in
  let rec from depth set =
    []
    ::
    (if depth = 0 then []
     else
       List.filter_map (fun (s, l, _) -> if l <> "tau" && List.mem s set then Some l else None) edges
       |> List.sort_uniq compare
       |> List.concat_map (fun l ->
           let next = List.filter_map (fun (s, m, t) -> if m = l && List.mem s set then Some t else None) edges in
           List.map (fun rest -> l :: rest) (from (depth - 1) (close next))))
  in
  List.sort compare (from depth (close [ 0 ]))

let time_steps ~unit_ g =
  let rest = (g : Graph.t).size in
  let next = ref (rest + 1) in
  let steps (s, l, t) =
    match Label.passing l with
    | None -> [ (s, l, t) ]
    | Some Forever -> [ (s, "tick", rest) ]
    | Some (For d) ->
      let n = Z.to_int (Rat.floor (Rat.mul d (Rat.of_int unit_))) in
      let rec chain from n =
        if n = 1 then [ (from, "tick", t) ]
        else begin
          let middle = !next in
          incr next;
          (from, "tick", middle) :: chain middle (n - 1)
        end
      in
      chain s n
  in
  let edges = List.concat_map steps (edges g) in
  make !next ((rest, "tick", rest) :: edges)
