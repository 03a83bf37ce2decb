let pick random list = List.nth list (Random.State.int random (List.length list))
let chance random percent = Random.State.int random 100 < percent

let number random list = pick random list

let velocity random ~plane =
  let one () = number random [ "0"; "1"; "-1"; "1"; "-1"; "1/2"; "2" ] in
  Printf.sprintf "(%s, %s, 0)" (one ()) (if plane then one () else "0")

let condition random ~plane =
  let variable = if plane then pick random [ "x"; "y" ] else "x" in
  let relation = pick random [ "<"; "<="; ">"; ">=" ] in
  Printf.sprintf "%s %s %s" variable relation (number random [ "0"; "1/2"; "1"; "-1" ])

let law random ~plane =
  let kick () =
    let weight = string_of_int (1 + Random.State.int random 3) in
    let weight =
      if chance random 15 then Printf.sprintf "(if %s then %s else 1)" (condition random ~plane) weight else weight
    in
    let v = velocity random ~plane in
    let v =
      if chance random 15 then
        Printf.sprintf "(if %s then 1 else -1, 0, 0)" (condition random ~plane)
      else v
    in
    Printf.sprintf "%s weight %s" v weight
  in
  if chance random 15 then velocity random ~plane
  else
    let kicks = List.init (2 + Random.State.int random 2) (fun _ -> kick ()) in
    Printf.sprintf "choose { %s }" (String.concat ", " kicks)

let shape =
  {|shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
|}

let formula random ~two ~plane ~any =
  let state () =
    pick random
      ([ "x(w) >= 1"; "x(w) > 1/2"; "bound(w, s)"; "event bounce(w)"; "event bind"; "vx(w) > 0"; "not bound(w, s)";
         "x(w) <= 0"; "behaviour(s) = Site"; "energy > 1"; "event bounce(w, east)"; "x(w) > start";
         "x(w) = start"; "behaviour(w) = Ready" ]
       @ (if two then [ "x(v) > x(w)"; "event bounce(v, w)" ] else [])
       @ if plane then [ "y(w) > 1"; "y(w) <= x(w)" ] else [])
  in
  let bound () = number random [ "1"; "3/2"; "2"; "2"; "5/2"; "3" ] in
  (* A claim that may fail on the way to the goal, while nothing else happens. *)
  let on_the_way () =
    let place = number random [ "1/4"; "1/2"; "3/4"; "1"; "5/4" ] in
    Printf.sprintf "P = ? [ (not x(w) = %s) U[<= %s] x(w) > %s ]" place (bound ())
      (number random [ "0"; "1/2"; "1"; "3/2" ])
  in
  (* Means that have an end, by a bound of time, and some that have none. *)
  let mean () =
    let sides = pick random [ "E = ?"; "E = ?"; "Emin = ?"; "Emax = ?"; "E <= 3/2"; "E > 1" ] in
    let horizon () = if chance random 85 then " or time >= " ^ bound () else "" in
    let number () =
      pick random
        ([ "x(w)"; "x(w)"; "2 * x(w) - start"; "vx(w)"; "max(x(w), 1)"; "if event bounce then 1 else x(w)";
           "if bound(w, s) then 1 else 0"; "time + x(w)" ]
         @ (if two then [ "x(w) - x(v)" ] else [])
         @ if plane then [ "x(w) + y(w) / 2"; "max(x(w), y(w))" ] else [])
    in
    match Random.State.int random 3 with
    | 0 -> Printf.sprintf "%s [ time U (%s)%s ]" sides (state ()) (horizon ())
    | 1 ->
      let happenings =
        pick random [ "event bounce"; "not event bind"; "event bind or event weak"; "event bounce(w)" ]
      in
      Printf.sprintf "%s [ %s U (%s)%s ]" sides happenings (state ()) (horizon ())
    | _ -> Printf.sprintf "%s [ %s at %s ]" sides (number ()) (bound ())
  in
  match Random.State.int random 8 with
  | _ when chance random 45 -> mean ()
  | _ when any && chance random 60 ->
    let released = pick random [ "eventually event weak"; "always not event weak"; "true U[1, 3] bound(w, s)" ] in
    if String.contains released 'U' then Printf.sprintf "P = ? [ %s ]" released
    else Printf.sprintf "P = ? [ %s within %s ]" released (number random [ "2"; "5/2"; "3" ])
  | 0 -> Printf.sprintf "P = ? [ always %s within %s ]" (state ()) (bound ())
  | 1 -> Printf.sprintf "P = ? [ (%s) U[<= %s] (%s) ]" (state ()) (bound ()) (state ())
  | 2 -> Printf.sprintf "P = ? [ true U[%s, %s] (%s) ]" (number random [ "1/2"; "1" ]) (bound ()) (state ())
  | 3 -> Printf.sprintf "Pmin = ? [ eventually %s within %s ]" (state ()) (bound ())
  | 4 ->
    let least = number random [ "1/2"; "1/3"; "1"; "2/9" ] in
    Printf.sprintf "P >= %s [ eventually %s within %s ]" least (state ()) (bound ())
  | 5 -> on_the_way ()
  | _ -> Printf.sprintf "P = ? [ eventually %s within %s ]" (state ()) (bound ())

let any_time = "split_step any\n"

let model random =
  let two = chance random 30 and plane = chance random 25 in
  let deep = plane && chance random 40 and apart = two && chance random 30 in
  let buffer = Buffer.create 1000 in
  let add format = Printf.bprintf buffer format in
  add "model m\ntimestep 1%s\n" (if chance random 30 then " steady" else "");
  let bonds = chance random 40 in
  (* With two walkers each more instant at which bonds may break is costly. *)
  let any = bonds && (not two) && chance random 60 in
  if bonds then add "%s" (if any then any_time else "split_step 1\n");
  add "param start in %s\n"
    (pick random (if any then [ "[1, 5/2]"; "(3/2, 3]" ] else [ "[0, 2]"; "(-1, 2]"; "[1/2, 5/2)"; "[-1, 1]" ]));
  if plane then add "param height in %s\n" (pick random [ "[0, 2]"; "[-1, 1/2)" ]);
  if deep then add "param depth in %s\n" (pick random [ "[1, 3]"; "(3/2, 5/2]" ]);
  if apart then add "param other in %s\n" (pick random [ "[-9/2, -4]"; "(-5, -4)" ]);
  add "%s" shape;
  let weak =
    if not bonds then ""
    else if any then "omega(b, {left}). "
    else "omega(b, {left}) " ^ pick random [ "chance 1/3"; "rate 1"; "" ] ^ ". "
  in
  add "behaviour Site on Cube = <b, {left}>. %snil\n" weak;
  add "behaviour Ligand on Cube = %sReady\n"
    (if chance random 25 then pick random [ "eps(3/4). "; "eps(1 + start / 2). " ] else "");
  add "behaviour Ready on Cube = <~b, {%s}>. %snil\n"
    (pick random [ "right"; "only right" ])
    (if bonds then "omega(b, {right}). " else "");
  let inert = if any then "Ligand" else pick random [ "nil"; "Ligand"; "Ligand" ] in
  add "process w = Cube mass 1 at translate (start, %s, %s) [%s]\n" (if plane then "height" else "0")
    (if deep then "depth" else "0") inert;
  if two then add "process v = Cube mass %s at translate (%s, 0, %s) velocity (%s, 0, 0) [nil]\n"
      (pick random [ "1"; "2" ])
      (if apart then "other" else pick random [ "-7/2"; "-4" ])
      (pick random [ "0"; "0"; "1" ])
      (pick random [ "1"; "0" ]);
  add "fixed s = Cube at translate (%s, %s, 0) [Site]\n" (pick random [ "5"; "11/2" ]) (pick random [ "0"; "1" ]);
  add "fixed east = Cube scaled (1, 9, 9)%s at translate (%s, 0, 0)\n"
    (if chance random 20 then " absorb" else "")
    (pick random [ "15/2"; "8" ]);
  add "fixed west = Cube scaled (1, 9, 9) at translate (%s, 0, 0)\n"
    (if two then "-7" else pick random [ "-3"; "-4"; "-7/2" ]);
  add "motion w = %s\n" (law random ~plane);
  if two && chance random 50 then add "motion v = %s\n" (law random ~plane:false);
  add "check c : %s\n" (formula random ~two ~plane ~any);
  Buffer.contents buffer
