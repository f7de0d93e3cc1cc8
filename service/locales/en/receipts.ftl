### The page that verifies a folder of receipts.

receipts-title = Receipts
receipts-lead = Drop the files that your students handed in, or paste their texts: every receipt is verified, and the grades become a file for Moodle or Canvas.
receipts-files = Files with receipts
receipts-paste = Or their texts, one after another
receipts-verify = Verify
receipts-none = There is no receipt yet.
receipts-found =
    { $all ->
        [1]
            { $valid ->
                [0] The receipt is not genuine.
               *[other] The receipt is genuine.
            }
       *[other] Genuine: { $valid } of { $all } receipts.
    }
receipts-save-csv = CSV
receipts-save-moodle = CSV for Moodle
receipts-save-canvas = CSV for Canvas
receipts-name = Name
receipts-exercise = Exercise
receipts-points = Points
receipts-time = Time
receipts-settings = Settings
receipts-said = Finding
receipts-genuine = genuine
receipts-repeated = genuine, but another receipt here has the same answer
receipts-by-link = by a lecturer’s link
receipts-answer = Answer
receipts-sign = Signed by { $service }. The code and the text below say the same; { $page } verifies them.
