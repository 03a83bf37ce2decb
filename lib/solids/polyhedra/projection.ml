let substitution variables equalities =
  let given e = Option.map (fun i -> (i, e)) (List.find_opt (Constraint.mentions e) variables) in
  List.find_map given equalities

let sign_in i (c : Constraint.t) = Z.sign c.normal.(i)

(* How many constraints more there are when it is gone. *)
let growth inequalities i =
  let count sign = List.length (List.filter (fun c -> sign_in i c = sign) inequalities) in
  let above = count 1 and below = count (-1) in
  (above * below) - above - below

let cheapest inequalities = function
  | [] -> Scc_base.Bug.fail __POS__ "no variable to eliminate"
  | first :: others ->
    let better (best, cost) i =
      let other = growth inequalities i in
      if other < cost then (i, other) else (best, cost)
    in
    fst (List.fold_left better (first, growth inequalities first) others)

let fourier_motzkin inequalities i =
  let having sign = List.filter (fun c -> sign_in i c = sign) inequalities in
  let below = having (-1) in
  let pairs c = List.map (fun d -> Constraint.resolve c d i) below in
  List.concat_map pairs (having 1) @ having 0

(* Without the variables that equalities give, as many as there are: no constraint comes of that that was not
   there. *)
let rec substitute variables equalities inequalities =
  match substitution variables equalities with
  | None -> (equalities, inequalities)
  | Some (i, by) ->
    let without = List.map (fun c -> Constraint.eliminate c i ~by) in
    let others = List.filter (fun e -> not (e == by)) equalities in
    substitute variables (without others) (without inequalities)

let step variables ~equalities inequalities =
  match substitution variables equalities with
  | Some _ ->
    let equalities, inequalities = substitute variables equalities inequalities in
    equalities @ inequalities
  | None -> equalities @ fourier_motzkin inequalities (cheapest inequalities variables)
