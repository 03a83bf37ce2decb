A filter for programs. The first line says what it is about:

  $ scc successors ../../specs/models/figure4.sc < /dev/null
  {"format":"scc-successors","version":2,"program":"0.1.0 (semantics 3)","state_bytes":1,"model":"figure4","digest":"md5:fac0abe803ba644ce82deb92bf81250b","parameters":{},"settings":{},"framing":"lines","reductions":["symmetry","translation","jump","slice","drift","time"],"bounds":{"instant":10000,"bits":100000},"exploration":1,"explorations":2,"horizon":null,"left_out":[],"checks":[{"name":"straight","formula":"always x(s0) - 2 = 2*(y(s0) - 3) and y(s0) - 3 = z(s0) - 1","premise":false,"plan":{"always":0}},{"name":"steady","formula":"always vx(s0) = 2 and vy(s0) = 1 and vz(s0) = 1","premise":false,"plan":{"always":1}},{"name":"passes","formula":"possibly x(s0) = 12 and y(s0) = 8 and z(s0) = 6","premise":false,"plan":{"possibly":2}},{"name":"leaves","formula":"eventually x(s0) > 1000","premise":false,"plan":null},{"name":"energetic","formula":"always energy = 9","premise":false,"plan":{"always":3}},{"name":"stays","formula":"always x(s0) <= 12","premise":false,"plan":{"always":4}}],"goals":[{"formula":"(x(s0) - 2) != (2 * (y(s0) - 3)) or (y(s0) - 3) != (z(s0) - 1)","within":null,"ahead":true},{"formula":"(vx(s0) != 2 or vy(s0) != 1) or vz(s0) != 1","within":null,"ahead":false},{"formula":"(x(s0) = 12 and y(s0) = 8) and z(s0) = 6","within":null,"ahead":true},{"formula":"energy != 9","within":null,"ahead":false},{"formula":"x(s0) > 12","within":null,"ahead":true}],"events":[],"initial":{"state":"010100010008040c04040400020008040404040400010004","fingerprint":"e8e2aa5cf3635032ea05dfbb9e13c560","goals":[false,false,false,false,false]}}

The example of specs/successors.md:

  $ echo 010100010008040c04040400020008040404040400010004 | scc successors ../../specs/models/figure4.sc | tail -n 1 > answer
  $ grep -cFf answer ../../specs/successors.md
  1

A state is answered by what follows it:

  $ cat > two.sc <<'END'
  > model two
  > shape C {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)  e (-1,-1,1)  f (1,-1,1)  g (1,1,1)  h (-1,1,1)
  >   faces bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
  > }
  > behaviour F on C = <link, {right}>. nil
  > behaviour G on C = <~link, {left}>. nil
  > process p = C mass 1 velocity (1,0,0) at translate (3,0,0) [F]
  > process q = C mass 1 at translate (6,0,0) [G]
  > check bound : possibly bound(p, q)
  > check near  : possibly x(p) > 7/2
  > check hit   : possibly event bind(link)
  > END
  $ scc successors two.sc < /dev/null > header
  $ grep -o '"checks".*"initial"' header
  "checks":[{"name":"bound","formula":"possibly bound(p, q)","premise":false,"plan":{"possibly":0}},{"name":"near","formula":"possibly x(p) > 7/2","premise":false,"plan":{"possibly":1}},{"name":"hit","formula":"possibly event bind(link)","premise":false,"plan":{"possibly":2}}],"goals":[{"formula":"bound(p, q)","within":null,"ahead":false},{"formula":"x(p) > 7/2","within":null,"ahead":true},{"formula":"event bind(link)","within":null,"ahead":true}],"events":["bind(link)"],"initial"
  $ state() { grep -o '"initial":{"state":"[0-9a-f]*' header | cut -d'"' -f6; }
  $ state | scc successors two.sc | tail -n +2
  {"fingerprint":"ebf6fc1d9469bb7fde1ec2085314b091","goals":[false,false,false],"ahead":[null,{"met":{"choice":0,"offset":"1/2","attained":false},"doubt":null},{"met":null,"doubt":null}],"follows":"moves","successors":[{"label":"time(1)","duration":"1/1","state":"0102000100100400040004010300040400040004000101180400040004020400000400040004000000","fingerprint":"7f63ab4430011e4ac70c31d7236d3f83","goals":[false,true,false]}]}

What is no state is told, and the next line is read:

  $ (echo; echo 0g; echo 00; echo 012; state | sed s/^01/02/; state | sed 's/$/00/'; state) | scc successors two.sc | tail -n +2 | cut -c1-120
  {"error":{"code":"SC0920","message":"this is no state of the model: it ends too early"}}
  {"error":{"code":"SC0920","message":"a state is written in the digits 0 to 9 and a to f"}}
  {"error":{"code":"SC0920","message":"this is no state of the model: it is of version 0, and 1 is read"}}
  {"error":{"code":"SC0920","message":"a state is written in pairs of digits, and here are 3 digits"}}
  {"error":{"code":"SC0920","message":"this is no state of the model: it is of version 2, and 1 is read"}}
  {"error":{"code":"SC0920","message":"this is no state of the model: there is more than a state"}}
  {"fingerprint":"ebf6fc1d9469bb7fde1ec2085314b091","goals":[false,false,false],"ahead":[null,{"met":{"choice":0,"offset":

A run that was found is replayed, and made a schedule:

  $ echo '{"goal": 0, "choices": [0, 0]}' | scc successors two.sc | tail -n +2 | tee run
  {"check":"bound","schedule":{"format":"scc-schedule","version":1,"model":"two.sc","check":"bound","digest":"md5:e10128775b3db19a624621dd6d765bc1","parameters":{},"choices":[{"choice":0,"label":"time(1)"},{"choice":0,"label":"bind(link, p.right, q.left)"}]}}
  $ sed 's/.*"schedule"://; s/}$//' run > run.json
  $ scc trace two.sc --schedule run.json --human | tail -n 4
          one process, velocity (1/2, 0, 0), <link, {p.right, q.left}>
            p at (4, 0, 0) [nil]
            q at (6, 0, 0) [nil]
  2 transitions, time 1: nothing will ever happen again
  $ (echo '{"goal": 0, "choices": [0]}'; echo '{"goal": 0, "choices": [0, 1]}'; echo '{"goal": 7, "choices": []}'; echo '{"goal"'; echo '{}') | scc successors two.sc | tail -n +2
  {"error":{"code":"SC0923","message":"the run does not meet goal 0"}}
  {"error":{"code":"SC0923","message":"step 2: there is no transition 1"}}
  {"error":{"code":"SC0923","message":"there is no goal 7"}}
  {"error":{"code":"SC0923","message":"this is not JSON"}}
  {"error":{"code":"SC0923","message":"a run is {\"goal\": a number, \"choices\": [numbers]}, or one with \"cycle\" instead"}}

Batches of columns. Kind 1 of the initial state, and then one that is no frame:

  $ cat > batch.py <<'END'
  > import struct, sys
  > state = bytes.fromhex(sys.argv[1])
  > body = struct.pack("<III", 1, 1, len(state)) + state
  > sys.stdout.buffer.write(struct.pack("<I", len(body)) + body + struct.pack("<IIII", 12, 9, 0, 0))
  > END
  $ python3 batch.py $(state) | scc successors two.sc --framing batches > out
  error[SC0921]: this is no batch of states: there is no request 9
  [3]
  $ tail -n +2 out | od -An -tx1
   da 00 00 00 01 00 00 00 01 00 00 00 b2 00 00 00
   00 01 00 00 00 00 01 00 7f 63 ab 44 30 01 1e 4a
   c7 0c 31 d7 23 6d 3f 83 00 00 00 00 7b 22 6c 61
   62 65 6c 73 22 3a 5b 7b 22 6c 61 62 65 6c 22 3a
   22 74 69 6d 65 28 31 29 22 2c 22 64 75 72 61 74
   69 6f 6e 22 3a 22 31 2f 31 22 7d 5d 2c 22 6e 6f
   74 65 73 22 3a 5b 7b 22 69 6e 64 65 78 22 3a 30
   2c 22 61 68 65 61 64 22 3a 5b 6e 75 6c 6c 2c 7b
   22 6d 65 74 22 3a 7b 22 63 68 6f 69 63 65 22 3a
   30 2c 22 6f 66 66 73 65 74 22 3a 22 31 2f 32 22
   2c 22 61 74 74 61 69 6e 65 64 22 3a 66 61 6c 73
   65 7d 2c 22 64 6f 75 62 74 22 3a 6e 75 6c 6c 7d
   2c 7b 22 6d 65 74 22 3a 6e 75 6c 6c 2c 22 64 6f
   75 62 74 22 3a 6e 75 6c 6c 7d 5d 7d 5d 7d 3d 00
   00 00 01 00 00 00 29 00 00 00 00 00 00 00 00 00
   01 00 29 00 00 00 01 02 00 01 00 10 04 00 04 00
   04 01 03 00 04 04 00 04 00 04 00 01 01 18 04 00
   04 00 04 02 04 00 00 04 00 04 00 04 00 00 00
  $ printf '\004\000\000' | scc successors two.sc --framing batches > out
  error[SC0921]: the input ends within a batch
  [3]
  $ printf '\377\377\377\377' | scc successors two.sc --framing batches > out
  error[SC0921]: a batch of 4294967295 bytes: 1073741824 is the most
  [3]
  $ printf '\014\000\000\000\002\000\000\000\377\377\377\377\000\000\000\000' | scc successors two.sc --framing batches > out
  error[SC0921]: this is no batch of states: it is shorter than it says
  [3]

Properties and explorations by name and number:

  $ scc successors two.sc --check near < /dev/null | grep -o '"goals".*"events"'
  "goals":[{"formula":"x(p) > 7/2","within":null,"ahead":true}],"events"
  $ scc successors two.sc --check far < /dev/null
  command line: error[SC0922]: the model has no property `far`
  [64]
  $ scc successors two.sc --exploration 2 < /dev/null
  command line: error[SC0922]: there is no exploration 2: these properties have 1
  [64]
  $ scc successors ../../specs/models/window.sc < /dev/null
  {"format":"scc-successors","version":2,"program":"0.1.0 (semantics 3)","state_bytes":1,"model":"window","digest":"md5:aa923209af7b701305c46adb89e1435f","parameters":{"grid":"1/1"},"settings":{"split step":"1"},"framing":"lines","reductions":["symmetry","translation","jump","slice","drift","time"],"bounds":{"instant":10000,"bits":100000},"exploration":1,"explorations":1,"horizon":"4/1","left_out":[],"checks":[{"name":"both","formula":"always bound(q, y) => bound(p, x) within 4","premise":false,"plan":{"always":0}},{"name":"some","formula":"possibly bound(q, y) within 4","premise":false,"plan":{"possibly":1}},{"name":"both","formula":"bound(q, y)","premise":true,"plan":{"possibly":2}}],"goals":[{"formula":"bound(q, y) and not bound(p, x)","within":"4/1","ahead":false},{"formula":"bound(q, y)","within":"4/1","ahead":false},{"formula":"bound(q, y)","within":"4/1","ahead":false}],"events":[],"initial":{"state":"01030102000004000400040103010804000400040204010200000b0100080004000400040004000102000400043c100305000004000406040001030804000416040406000004000404040000","fingerprint":"23dd91e35c01d831feb17cc8d2704a9c","goals":[false,false,false]}}
  $ scc successors - < /dev/null
  scc: the model cannot be read from standard input, which is for states
  [64]

Nobody reads the answers, or they cannot be written:

  $ yes "$(state)" 2>/dev/null | python3 -B unread.py scc successors two.sc 2>/dev/null
  [4]
  $ scc successors two.sc < /dev/null > /dev/full
  standard output: error[SC0103]: cannot write: No space left on device
  [74]
