(* Characters that change the direction of a text: which, where they are told, and that nothing prints them. *)

open Scc_base

let utf_8 code =
  let b = Buffer.create 4 in
  Buffer.add_utf_8_uchar b (Uchar.of_int code);
  Buffer.contents b

let warnings text = Direction.warnings (Source.make ~name:"m.sc" text)
let is_one code = (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069)
let is_control code = (code < 0x20 && code <> 0x09 && code <> 0x0A) || (code >= 0x7F && code < 0xA0)

(* Every code point there is, in the middle of a comment. *)
let which () =
  for code = 1 to 0x10FFFF do
    if Uchar.is_valid code then begin
      let c = utf_8 code in
      let text = "// a" ^ c ^ "b" in
      let found = warnings text and shown = Visible.text text in
      let named = Printf.sprintf "U+%04X" code in
      let expected = if is_one code || is_control code then "// a<" ^ named ^ ">b" else text in
      if List.length found <> Bool.to_int (is_one code) || not (String.equal shown expected) then
        Alcotest.failf "%s: %d warnings, shown as %S" named (List.length found) shown
    end
  done

let where () =
  let rlo = utf_8 0x202E and pdi = utf_8 0x2069 in
  let places text =
    List.map
      (fun (d : Diag.t) ->
         let l, c = Source.position (Source.make ~name:"m.sc" text) d.span.start in
         Printf.sprintf "%s %d:%d" d.code l c)
      (warnings text)
  in
  let check what expected text = Alcotest.(check (list string)) what expected (places text) in
  check "none" [] "";
  check "one a line" [ "SC0113 1:3"; "SC0113 3:1"; "SC0113 4:2" ]
    (Printf.sprintf "ab%sc%s%s\r\n\n%s\na%s" rlo pdi rlo rlo pdi);
  check "cut off" [] (String.sub rlo 0 2);
  check "alone" [ "SC0113 1:1" ] rlo;
  check "after others that begin alike" [ "SC0113 1:3" ] ("\xE2\x80\xA9\xE2\x88\x92" ^ rlo);
  check "in binary" [] (rlo ^ "\000");
  let many n = String.concat "\n" (List.init n (fun _ -> pdi)) in
  let told n = List.map (fun (d : Diag.t) -> d.message) (warnings (many n)) in
  Alcotest.(check int) "20 lines" 20 (List.length (told 20));
  List.iter
    (fun n ->
       let messages = told n in
       Alcotest.(check int) "and one for all others" 21 (List.length messages);
       let last = List.nth messages 20 in
       let lines = Printf.sprintf "on %d more lines, " (n - 20) in
       Alcotest.(check string) "how many" lines (String.sub last 0 (String.length lines)))
    [ 21; 22; 100_000 ];
  let million = String.concat "" (List.init 1_000_000 (fun _ -> rlo)) in
  Alcotest.(check int) "a million in a line" 1 (List.length (warnings million))

(* Control characters that no text has are those that reports write out, but for tabs and line ends. *)
let controls () =
  for code = 0 to 0x10FFFF do
    if code < 0xD800 || code > 0xDFFF then begin
      let c = utf_8 code in
      let is_allowed = List.mem code [ 0x09; 0x0A; 0x0C; 0x0D ] || Option.is_some (Bidirectional.at c 0) in
      let expected =
        if Option.is_some (Visible.at c 0) && not is_allowed then
          Some (Utf8.Control { at = 2; size = String.length c; code })
        else None
      in
      if Utf8.check ("ab" ^ c ^ "d") <> expected then Alcotest.failf "U+%04X" code
    end
  done

(* Each line tells of its own characters, each once, and points at the first. *)
let told () =
  let rlo = utf_8 0x202E and pdi = utf_8 0x2069 in
  let text d = Printf.sprintf "%d-%d %s" d.Diag.span.start d.span.stop d.message in
  let check what expected s = Alcotest.(check (list string)) what expected (List.map text (warnings s)) in
  let ends = " the direction in which it is shown: what is read may not be what is seen" in
  check "several of them, and some twice"
    [
      "1-4 the characters U+202E, U+2069 on this line change" ^ ends;
      "12-15 the character U+2069 on this line changes" ^ ends;
      "19-22 the character U+202E on this line changes" ^ ends;
    ]
    (Printf.sprintf "a%sb%s%s\n%s%s\n%s" rlo pdi rlo pdi pdi rlo);
  check "after a form feed" [ "1-4 the character U+202E on this line changes" ^ ends ] ("\012" ^ rlo);
  check "in what is no text" [] ("\127" ^ rlo);
  let lines = List.map text (warnings (String.concat "\n" (List.init 23 (fun _ -> pdi)))) in
  Alcotest.(check string) "the first of those beyond"
    "80-83 on 3 more lines, of which this is the first, are characters that change the direction of the text"
    (List.nth lines 20)

(* Whatever a diagnostic says, and wherever it points. *)
let shown () =
  let rlo = utf_8 0x202E in
  let text = Printf.sprintf "x%sy /* %s */ ß%s z\n" rlo rlo rlo in
  let source = Source.make ~name:"m.sc" text in
  for start = 0 to String.length text do
    let span = Span.make ~file:"m.sc" ~start ~stop:(min (start + 4) (String.length text)) in
    let d = Diag.error Code.lexical span ~notes:[ (span, "note" ^ rlo) ] ~hint:rlo "it is `%s`" rlo in
    let rendered = Diag.render ~source:(fun _ -> Some source) d in
    if Option.is_some (Bidirectional.next rendered 0) then Alcotest.failf "printed: %S" rendered
  done;
  let at = 9 in
  let d = Diag.error Code.lexical (Span.make ~file:"m.sc" ~start:at ~stop:(at + 3)) "it" in
  Alcotest.(check string) "carets"
    "m.sc:1:8: error[SC0104]: it\n   |\n 1 | x<U+202E>y /* <U+202E> */ ß<U+202E> z\n   |               ^^^^^^^^\n"
    (Diag.render ~source:(fun _ -> Some source) d)

let suite =
  ( "directions",
    [
      ( "characters",
        [
          Alcotest.test_case "which they are" `Quick which;
          Alcotest.test_case "control characters" `Quick controls;
          Alcotest.test_case "where they are told" `Quick where;
          Alcotest.test_case "what is told" `Quick told;
          Alcotest.test_case "how they are shown" `Quick shown;
        ] );
    ] )
