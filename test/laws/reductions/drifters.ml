(* Networks of a few cubes and pairs of cubes, most of which fly apart, with splits and delays still to come. *)

module Gen = QCheck2.Gen

let behaviours =
  {|
behaviour Pulse  = eps(1). Rest
behaviour Rest   = eps(1/2). Pulse
behaviour Thrust = omega(dock, {left, right}) push(1). Shy
behaviour Part   = omega(dock, {left, right}). Free
behaviour Free   = <dock, {right}>. Part + <~dock, {left}>. Part
behaviour Kick   = eps(1). rho({<dock, {left, right}>}) push(2). Free
|}

let lucky =
  {|
behaviour Lucky  = omega(dock, {left, right}) chance 1/2. Free
behaviour Either = omega(dock, {left, right}). Shy + omega(dock, {left, right}). Free
|}

(* A cube, or two that are bound; in a cell of its own of a grid, and as a rule away from the middle. *)
type item = {
  pair : bool;
  cell : int * int;
  mass : int;
  velocity : string;
  bonded : string * string;
  alone : string;
}

let velocity (i, j) =
  let open Gen in
  let outward k = if k = 0 then -1 else if k = 3 then 1 else 0 in
  let* away = bool and* x = oneofl [ "0"; "1"; "-1"; "2"; "-2"; "1/2"; "-1/2" ] in
  let* y = frequencyl [ (4, "0"); (1, "1"); (1, "-1") ] and* fast = oneofl [ 1; 2; 3 ] in
  let up = if j = 0 then 0 else fast - 1 in
  return (if away then Printf.sprintf "(%d,%d,0)" (fast * outward i) up else Printf.sprintf "(%s,%s,0)" x y)

(* Away from others up and down, past each other along x. *)
let across (i, j) =
  let open Gen in
  let+ x = oneofl [ "0"; "1/4"; "-1/4"; "1/8" ] and+ fast = oneofl [ 1; 2 ] in
  Printf.sprintf "(%s,%d,0)" x ((if j = 0 then -1 else 1) * (fast + i))

(* [chance] has pairs, as a rule, that are left to chance, and of which others are free to choose how. *)
let item ~chance cell =
  let open Gen in
  let bonded = [ "Held"; "Held"; "Part"; "Thrust"; "Kick"; "Pulse" ] in
  let lots = oneofl [ ("Lucky", "Lucky"); ("Lucky", "Either"); ("Either", "Lucky"); ("Lucky", "Held") ] in
  let* bound = if chance then frequencyl [ (3, true); (1, false) ] else bool in
  let* velocity = if chance then oneof [ velocity cell; across cell; across cell ] else velocity cell in
  let* mass = oneofl [ 1; 1; 2 ] in
  let+ bonded = if chance then lots else map (fun b -> (b, b)) (oneofl bonded)
  and+ alone = oneofl [ "Shy"; "Shy"; "Pulse"; "Free"; "Late" ] in
  { pair = bound; cell; mass; velocity; bonded; alone }

let written first i =
  let x, y = (8 * fst i.cell, 5 * snd i.cell) in
  let cube ?(name = first) x behaviour =
    Printf.sprintf "p%d : Cube mass %d velocity %s at translate (%d,%d,0) [%s]" name i.mass i.velocity x y
      behaviour
  in
  if i.pair then
    Printf.sprintf "process d%d = %s <dock, {p%d.right, p%d.left}>\n  %s" first
      (cube x (fst i.bonded))
      first (first + 1)
      (cube ~name:(first + 1) (x + 2) (snd i.bonded))
  else
    Printf.sprintf "process p%d = Cube mass %d velocity %s at translate (%d,%d,0) [%s]" first i.mass i.velocity x y
      i.alone

let gen =
  let open Gen in
  let cells = List.concat_map (fun i -> [ (i, 0); (i, 1) ]) [ 0; 1; 2; 3 ] in
  let* k = int_range 1 3 and* cells = shuffle_l cells and* chance = map (fun n -> n = 0) (0 -- 4) in
  let* items = flatten_l (List.map (item ~chance) (List.filteri (fun i _ -> i < k) cells)) in
  let* wall = frequencyl [ (3, None); (1, Some ""); (1, Some " absorb") ] and* at = oneofl [ -6; 13; 34 ] in
  let standing w = Printf.sprintf "fixed wall = Cube scaled (1,20,1)%s at translate (%d,0,0)" w at in
  let walls = List.map standing (Option.to_list wall) in
  let add (n, lines) i = ((n + if i.pair then 2 else 1), lines @ [ written n i ]) in
  let n, lines = List.fold_left add (0, []) items in
  let* setting = frequencyl [ (5, []); (1, [ "collisions together" ]); (1, [ "binding contact" ]) ] in
  let lucky = if chance then [ lucky ] else [] in
  return (n, String.concat "\n" ((Crowds.shapes :: behaviours :: lucky) @ setting @ lines @ walls))

(* Comparisons of places with constants near and far, and more that no constant ends. *)
let far_atom n =
  let open Gen in
  let leaf = map (Printf.sprintf "p%d") (int_range 0 (n - 1)) in
  let* p = leaf and* q = leaf and* c = int_range (-10) 40 and* comparison = oneofl [ "<"; "<="; ">"; ">="; "=" ] in
  frequencyl
    [
      (4, Printf.sprintf "x(%s) %s %d" p comparison c);
      (1, Printf.sprintf "y(%s) %s %d" p comparison (c / 4));
      (4, Printf.sprintf "distance2(%s, %s) %s %d" p q comparison (20 * abs c));
      (1, Printf.sprintf "2 * distance2(%s, %s) - processes %s %d" p q comparison (10 * abs c));
      (1, Printf.sprintf "x(%s) %s x(%s) + %d" p comparison q c);
      (1, Printf.sprintf "distance2(%s, %s) %s %d + time" p q comparison (20 * abs c));
      (1, Printf.sprintf "(if bound(%s, %s) then x(%s) else %d) %s 3" p q p c comparison);
      (1, Printf.sprintf "touching(%s, %s)" p q);
      (2, Printf.sprintf "time %s %d" comparison (abs c / 4));
    ]

let formula n =
  let open Gen in
  let atom = frequency [ (2, far_atom n); (1, Crowds.atom_gen n) ] in
  Crowds.formula_of atom

let case = Crowds.case_of ~crowd:gen formula

(* Such models with predicates alone. *)
let with_predicates =
  let open Gen in
  let predicate n = map (Printf.sprintf "possibly (%s)") (far_atom n) in
  let all n = map (Printf.sprintf "possibly (%s)") (Crowds.atom_gen n) in
  let* n, text = gen in
  let* some = list_size (int_range 0 2) (predicate n) and* others = list_size (int_range 0 3) (all n) in
  let checks = List.mapi (Printf.sprintf "check c%d : %s") (some @ others) in
  return (text ^ "\n" ^ String.concat "\n" checks)
