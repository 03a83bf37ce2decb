(* When what is noted is kept. *)

open Scc_parallel

let check = Alcotest.(check (list string))

let blocks ?full () =
  let log, kept = Kept_in_memory.log [] in
  let b = Blocks.make ?full log in
  (b, kept, fun text -> Blocks.add b (fun buffer -> Buffer.add_string buffer text))

let full () =
  let b, kept, note = blocks ~full:3 () in
  List.iter note [ "a"; "bc"; "d" ];
  check "a block that is full" [ "abc" ] (kept ());
  Blocks.write b;
  check "and what is left" [ "abc"; "d" ] (kept ())

(* As a state that takes long. *)
let work_for seconds =
  ignore (Sys.opaque_identity (List.init 200_000 Fun.id));
  Unix.sleepf seconds

(* After so many quick ones that few of them look at the clock; after how many of these it comes does not
   matter. *)
let slow () =
  for quick = 1000 to 1007 do
    let b, kept, note = blocks () in
    for _ = 1 to quick do
      note "x"
    done;
    Blocks.write b;
    let before = List.length (kept ()) in
    work_for 0.05;
    note "y";
    Alcotest.(check int) "what takes long is kept at once" (before + 1) (List.length (kept ()))
  done

let () =
  Alcotest.run "blocks"
    [
      ( "written",
        [ Alcotest.test_case "when full" `Quick full; Alcotest.test_case "after a slow note" `Quick slow ] );
    ]
