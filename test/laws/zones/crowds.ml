let pick list = List.nth list (Random.int (List.length list))

let head =
  {|model crowd
split_step any
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour Port  on Cube = <~a, {left, right, front, back}>. nil
|}

(* Two or four that go round a square of walls, bouncing off each in turn, on one way of length 20 (along x): they
   are where another one was after a while, if they are spaced evenly. *)

let round n =
  let base = 1 + Random.int 4 and offset = pick [ "0"; "d"; "d"; "-d" ] in
  let odd = if Random.int 4 = 0 then Random.int n else -1 in
  let ridden = Random.int 4 = 0 in
  let behaviour = if ridden then "Under" else pick [ "nil"; "nil"; "Going"; "eps(2 * d + 1). nil" ] in
  let one i =
    let offset = if i = odd then pick [ "0"; "d / 2" ] else offset in
    let u = Printf.sprintf "(%d + %s)" base offset in
    let place, velocity =
      match i * 4 / n with
      | 0 -> (Printf.sprintf "-5 + %s, -%s" u u, "(1, -1, 0)")
      | 1 -> (Printf.sprintf "%s, -5 + %s" u u, "(1, 1, 0)")
      | 2 -> (Printf.sprintf "5 - %s, %s" u u, "(-1, 1, 0)")
      | _ -> (Printf.sprintf "-%s, 5 - %s" u u, "(-1, -1, 0)")
    in
    let body name z behaviour =
      Printf.sprintf "process %s[%d] = Cube mass 1 velocity %s at translate (%s, %d) [%s]\n" name (i + 1) velocity
        place z behaviour
    in
    if ridden then
      body "p" 0 behaviour ^ body "q" 2 "Above"
      ^ Printf.sprintf "bond <link, {p[%d].top, q[%d].bottom}>\n" (i + 1) (i + 1)
    else body "p" 0 (if Random.int 6 = 0 then "nil" else behaviour)
  in
  String.concat "" (List.init n one)

let walls =
  {|param d in [-1/2, 1/2]
behaviour Going on Cube = eps(5). Going
behaviour Under on Cube = eps(12). omega(link, {top}). nil
behaviour Above on Cube = eps(12). omega(link, {bottom}). nil
fixed west  = Cube scaled (1,5,1) at translate (-7,0,0)
fixed south = Cube scaled (5,1,1) at translate (0,-7,0)
fixed north = Cube scaled (5,1,1) at translate (0,7,0)
|}

let text () =
  let n = pick [ 2; 2; 4 ] in
  let absorb = pick [ ""; ""; ""; "absorb" ] in
  let east = Printf.sprintf "fixed east = Cube scaled (1,5,1) %s at translate (7,0,0)\n" absorb in
  let others = pick [ ""; "process seat = Cube mass 1 at translate (0, 0, 0) [Port]\n" ] in
  let atoms =
    [ "exists b in p: x(b) >= 5"; "exists b in p: vx(b) > 0 and vy(b) > 0"; "forall b in p: vx(b) = vy(b)";
      "event bounce and exists b in p: vx(b) = 1"; "exists b in p: x(b) = 5"; "processes < 3";
      "exists b in p: exists c in p: touching(b, c)" ]
  in
  let named = [ "x(p[1]) >= 4"; "event bounce(p[1])"; "touching(p[1], south)" ] in
  let names = Random.int 3 = 0 in
  let atom () = pick (if names then named @ atoms else atoms) in
  let prop () = if Random.bool () then Printf.sprintf "(%s) and (%s)" (atom ()) (atom ()) else atom () in
  let single () =
    let kind = pick ([ "possibly"; "always"; "always not"; "possibly not" ] @ if names then [ "AG EF" ] else []) in
    Printf.sprintf "%s (%s)" kind (prop ())
  in
  (* Each names one of two that change places. *)
  let several () =
    let kind, connect = pick [ ("possibly", "and"); ("always not", "or") ] in
    let coming p = Printf.sprintf "x(%s) > 4 and vx(%s) > 0" p p in
    let atom = pick [ coming; Printf.sprintf "touching(%s, east)" ] in
    Printf.sprintf "(%s (%s)) %s (%s (%s))" kind (atom "p[1]") connect kind (atom "p[2]")
  in
  let check i =
    Printf.sprintf "check c%d : %s\n" i (if Random.int 3 = 0 then several () else single ())
  in
  head ^ walls ^ east ^ round n ^ others ^ String.concat "" (List.init 2 check)
