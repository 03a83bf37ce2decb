(* Models as text, and formulas about them. *)

module Gen = QCheck2.Gen

(* {1 Random crowds of unit cubes on a grid} *)

let shapes =
  {|
timestep 1
split_step 1
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
behaviour Shy    = nil
behaviour Right  = <dock, {right}>. Held
behaviour Left   = <~dock, {left}>. Held
behaviour Both   = <dock, {right}>. Held + <~dock, {left}>. Held
behaviour Held   = omega(dock, {left, right}). Shy
behaviour Urgent = <dock, {right}>. rho({<dock, {right}>}). Shy + <~dock, {left}>. rho({<dock, {left}>}). Shy
behaviour Late   = eps(2). Both
|}

let behaviours = [ "Shy"; "Right"; "Left"; "Both"; "Urgent"; "Late" ]

let body_gen =
  let open Gen in
  let* velocity = frequencyl [ (3, (0, 0)); (2, (1, 0)); (2, (-1, 0)); (1, (0, 1)); (1, (0, -1)) ] in
  let* behaviour = frequencyl (List.map (fun b -> ((if b = "Shy" then 2 else 1), b)) behaviours) in
  return (velocity, behaviour)

(* Bodies on different places of a grid: those of one row and next to each other touch, others are apart. *)
let crowd_gen =
  let open Gen in
  let* n = int_range 2 5 in
  let* places = shuffle_l (List.concat_map (fun x -> List.map (fun y -> (x, y)) [ 0; 1 ]) [ 0; 1; 2; 3 ]) in
  let* bodies = list_repeat n body_gen in
  let* gap = oneofl [ 2; 4 ] in
  let* wall = frequencyl [ (2, None); (1, Some ""); (1, Some " absorb") ] in
  let kicks = "choose { (1,0,0) weight 2, (-1,0,0), (vx, vy, vz) }" in
  let* law =
    frequencyl
      [
        (6, []); (1, [ "motion p0 = (vx, vy, vz - dt)" ]); (1, [ "motion p1 = " ^ kicks ]);
        (1, [ "motion p0 = " ^ kicks; "motion p1 = " ^ kicks ]);
      ]
  in
  let body i ((vx, vy), behaviour) =
    let x, y = List.nth places i in
    Printf.sprintf "process p%d = Cube mass 1 velocity (%d,%d,0) at translate (%d,%d,0) [%s]" i vx vy (gap * x)
      (6 * y) behaviour
  in
  let standing = Printf.sprintf "fixed wall = Cube scaled (1,20,1)%s at translate (30,0,0)" in
  let walls = List.map standing (Option.to_list wall) in
  return (n, String.concat "\n" ((shapes :: List.mapi body bodies) @ walls @ law))

(* Some of the same in a square, that bind with all neighbours: bonds close rings (reading I-37). *)
let ringed_gen =
  let open Gen in
  let link =
    {|bonds cyclic
behaviour Link = <dock, {left, right, front, back}>. Link + <~dock, {left, right, front, back}>. Link
              + eps(1). Linked
behaviour Linked = rho({<dock, {left, right}>, <dock, {front, back}>}). Held + omega(dock, {left, right}). Link|}
  in
  let* places = shuffle_l [ (0, 0); (0, 1); (1, 0); (1, 1); (2, 0) ] in
  let* n = int_range 3 5 and* gap = frequencyl [ (2, 2); (1, 4) ] in
  let* rest = frequencyl [ (1, true); (2, false) ] in
  let* velocities = list_repeat n (frequencyl [ (2, (1, 0)); (2, (-1, 0)); (1, (0, 1)); (1, (0, -1)) ]) in
  let* behaviours = list_repeat n (frequencyl [ (5, "Link"); (1, "Both"); (1, "Shy") ]) in
  let body i (vx, vy) behaviour =
    let x, y = List.nth places i in
    let vx, vy = if rest && i > 0 then (0, 0) else (vx, vy) in
    Printf.sprintf "process p%d = Cube mass 1 velocity (%d,%d,0) at translate (%d,%d,0) [%s]" i vx vy
      (gap * x) (2 * y) behaviour
  in
  let bodies = List.mapi (fun i v -> body i v (List.nth behaviours i)) velocities in
  return (n, String.concat "\n" (shapes :: link :: bodies))

(* {1 Random formulas} *)

let atom_gen n =
  let open Gen in
  let leaf = map (Printf.sprintf "p%d") (int_range 0 (n - 1)) in
  let one =
    oneof
      [
        map2 (Printf.sprintf "bound(%s, %s)") leaf leaf;
        map2 (Printf.sprintf "touching(%s, %s)") leaf leaf;
        map (Printf.sprintf "vx(%s) > 0") leaf;
        map2 (Printf.sprintf "x(%s) > %d") leaf (int_range (-4) 12);
        map2 (Printf.sprintf "size(%s) >= %d") leaf (int_range 2 3);
        map2 (Printf.sprintf "distance2(%s, %s) < 17") leaf leaf;
        map (Printf.sprintf "behaviour(%s) = Held") leaf;
        map2 (Printf.sprintf "same(%s, %s)") leaf leaf;
        map2 (Printf.sprintf "bonds(dock, %s, %s) > 0") leaf leaf; map (Printf.sprintf "offers(%s, dock)") leaf;
        map (Printf.sprintf "gone(%s)") leaf; map (Printf.sprintf "speed2(%s) >= 1") leaf;
        map (Printf.sprintf "spin2(%s) = 0") leaf;
      ]
  and all =
    oneof
      [
        map (Printf.sprintf "bonds(dock) >= %d") (int_range 1 2);
        return (Printf.sprintf "processes < %d" n);
        return "exists a in Cube: vy(a) > 0";
        return "count(a in Cube: behaviour(a) = Held) >= 2";
        return "exists a in Cube: exists b in Cube: not same(a, b) and touching(a, b) and vx(a) > 0";
        return "energy > 1";
        oneofl [ "momentum.x > 0"; "angular.z > 0"; "bonds() = 0"; "quiescent" ];
      ]
  in
  let bind = map (Printf.sprintf "event bind(dock, %s)") leaf in
  let parting = oneofl [ "event split(dock)"; "event weak"; "event strong(dock)" ] in
  frequency [ (6, one); (6, all); (2, bind); (2, return "event bounce"); (1, parting) ]

let formula_of atom =
  let open Gen in
  let* p = atom and* q = atom in
  let state = oneofl [ p; Printf.sprintf "(%s and %s)" p q; Printf.sprintf "(%s => %s)" p q; "not " ^ p ] in
  let* s = state and* within = frequencyl [ (2, ""); (1, " within 3") ] in
  frequencyl
    [
      (4, Printf.sprintf "possibly (%s)%s" s within);
      (4, Printf.sprintf "always (%s)%s" s within);
      (2, Printf.sprintf "eventually (%s)%s" s within);
      (1, Printf.sprintf "EG (%s)" s);
      (1, Printf.sprintf "AG EF (%s)" s);
      (1, Printf.sprintf "EX (%s)" s);
      (1, Printf.sprintf "A[ (%s) U (%s) ]" p q);
      (1, Printf.sprintf "(%s) leads_to (%s)" p q);
      (1, Printf.sprintf "EF[1, 3] (%s)" s);
      (1, Printf.sprintf "P = ? [ eventually (%s)%s ]" s within);
      (1, Printf.sprintf "Pmin = ? [ (%s) U (%s) ]" p q);
      (1, Printf.sprintf "P >= 1/2 [ always (%s)%s ]" s within);
      (1, Printf.sprintf "E = ? [ time U (%s) ]" s);
      (1, Printf.sprintf "Emax = ? [ event bounce U (%s) ]" s);
      (1, "E = ? [ energy at 2 ]");
      (1, "E = ? [ processes + momentum.x at 5/2 ]");
      (1, Printf.sprintf "AG (Pmax <= 2/3 [ eventually[1, 2] (%s) ])" s);
    ]

let formula_gen n = formula_of (atom_gen n)

(* Comparisons of time with constants, with what changes, and within other atoms. *)
let time_atom_gen n =
  let open Gen in
  let leaf = map (Printf.sprintf "p%d") (int_range 0 (n - 1)) in
  let compared =
    let* comparison = oneofl [ "<"; "<="; ">"; ">="; "="; "!=" ] and* c = int_range 0 8 in
    oneofl
      [
        Printf.sprintf "time %s %d" comparison c;
        Printf.sprintf "%d %s time" c comparison;
        Printf.sprintf "3 * time - 1 %s %d" comparison c;
        Printf.sprintf "%d - time / 2 %s 1" c comparison;
      ]
  in
  frequency
    [
      (6, compared);
      (1, map2 (Printf.sprintf "count(a in Cube: %s and touching(a, %s) or vx(a) > 0) >= 1") compared leaf);
      (1, map2 (Printf.sprintf "x(%s) < time - %d") leaf (int_range 0 4));
      (1, map (Printf.sprintf "time * time > %d") (int_range 0 20));
    ]

let some_with_time n =
  let open Gen in
  let timed =
    let* p = time_atom_gen n and* q = atom_gen n in
    oneofl [ p; Printf.sprintf "%s and %s" p q; Printf.sprintf "(%s => %s)" p q ]
  in
  formula_of (frequency [ (2, timed); (1, atom_gen n) ])

let case_of ?(crowd = crowd_gen) formula_gen =
  let open Gen in
  let* n, text = crowd in
  let* formulas = list_size (int_range 1 3) (formula_gen n) in
  let checks = List.mapi (fun i f -> Printf.sprintf "check c%d : %s" i f) formulas in
  return (text ^ "\n" ^ String.concat "\n" checks)

let case_gen = case_of formula_gen
let ringed_case_gen = case_of ~crowd:ringed_gen formula_gen
let timed_case_gen = case_of some_with_time
