let of_temporal formulas =
  let found = ref [] and count = ref 0 in
  let number p =
    match List.find_opt (fun (q, _) -> Formula.equal_prop p q) !found with
    | Some (_, k) -> k
    | None ->
      let k = !count in
      found := (p, k) :: !found;
      incr count;
      k
  in
  let rec go (f : Property.temporal) : Scc_ctl.Formula.t =
    match f with
    | State p -> Predicate (number p)
    | Temporal_not f -> Not (go f)
    | Temporal_and l -> And (List.map go l)
    | Temporal_or l -> Or (List.map go l)
    | Next (q, f) -> Next (q, go f)
    | Finally (q, b, f) -> Finally (q, b, go f)
    | Globally (q, b, f) -> Globally (q, b, go f)
    | Until (q, b, f, g) ->
      let f = go f in
      Until (q, b, f, go g)
  in
  let formulas = List.map go formulas in
  (formulas, Array.of_list (List.rev_map fst !found))

let rec to_temporal prop (f : Scc_ctl.Formula.t) : Property.temporal =
  let go = to_temporal prop in
  match f with
  | Predicate k -> State (prop k)
  | Not f -> Temporal_not (go f)
  | And fs -> Temporal_and (List.map go fs)
  | Or fs -> Temporal_or (List.map go fs)
  | Next (q, f) -> Next (q, go f)
  | Finally (q, b, f) -> Finally (q, b, go f)
  | Globally (q, b, f) -> Globally (q, b, go f)
  | Until (q, b, f, g) -> Until (q, b, go f, go g)
